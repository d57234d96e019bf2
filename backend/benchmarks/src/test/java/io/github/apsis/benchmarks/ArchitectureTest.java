package io.github.apsis.benchmarks;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.lang.ArchRule;
import io.github.apsis.benchmarks.cli.ApsisBench;
import org.junit.jupiter.api.Test;

class ArchitectureTest {
    private static final ArchRule NO_SERVER_AND_NO_SPRING = classes()
            .that()
            .resideInAPackage("io.github.apsis.benchmarks..")
            .should()
            .onlyDependOnClassesThat(resideInAnyPackage(
                    "io.github.apsis.benchmarks..",
                    "io.github.apsis.engine..",
                    "io.github.apsis.scenes..",
                    "io.github.apsis.protocol..",
                    "picocli..",
                    "tools.jackson..",
                    "org.knowm.xchart..",
                    "org.dyn4j..",
                    "org.jbox2d..",
                    "org.locationtech.jts..",
                    "org.openjdk.jmh..",
                    "com.badlogic.gdx..",
                    "org.jspecify.annotations..",
                    "com.sun.management..",
                    "javax.imageio..",
                    "java.."));

    private static final ArchRule MEASURING_DOES_NOT_KNOW_THE_COMMAND_LINE = noClasses()
            .that()
            .resideInAnyPackage(
                    "io.github.apsis.benchmarks",
                    "io.github.apsis.benchmarks.accuracy..",
                    "io.github.apsis.benchmarks.contacts..",
                    "io.github.apsis.benchmarks.discs..",
                    "io.github.apsis.benchmarks.kernels..",
                    "io.github.apsis.benchmarks.reference..",
                    "io.github.apsis.benchmarks.report..",
                    "io.github.apsis.benchmarks.speed..",
                    "io.github.apsis.benchmarks.steering..")
            .should()
            .dependOnClassesThat(resideInAnyPackage("io.github.apsis.benchmarks.cli..", "picocli.."));

    private final JavaClasses main = new ClassFileImporter()
            .withImportOption(new DoNotIncludeTests())
            .importPackages("io.github.apsis.benchmarks");

    private final JavaClasses offenders = new ClassFileImporter().importClasses(Offender.class);

    @Test
    void benchmarks_know_neither_server_nor_spring() {
        NO_SERVER_AND_NO_SPRING.check(main);

        assertFails(NO_SERVER_AND_NO_SPRING);
    }

    @Test
    void measuring_does_not_know_the_command_line() {
        MEASURING_DOES_NOT_KNOW_THE_COMMAND_LINE.check(main);

        assertFails(MEASURING_DOES_NOT_KNOW_THE_COMMAND_LINE);
    }

    /** A rule that cannot fail proves nothing. */
    private void assertFails(ArchRule rule) {
        assertThatThrownBy(() -> rule.check(offenders)).isInstanceOf(AssertionError.class);
    }

    /** Breaks every rule of this class. */
    record Offender(JavaClass foreign, ApsisBench upwards) {}
}
