package io.github.apsis.scenes;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;

/** The arrows of docs that concern scenes: they know the engine, and JTS in one package. */
class ArchitectureTest {
    private static final Set<String> INEXACT =
            Set.of("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "pow", "cbrt", "hypot");

    private static final ArchRule SCENES_KNOW_ONLY_THE_ENGINE = classes()
            .that()
            .resideInAPackage("io.github.apsis.scenes..")
            .should()
            .onlyDependOnClassesThat(resideInAnyPackage(
                    "io.github.apsis.scenes..",
                    "io.github.apsis.engine..",
                    "org.locationtech.jts..",
                    "org.jspecify.annotations..",
                    "java.."));

    private static final ArchRule JTS_STAYS_IN_SHAPE = noClasses()
            .that()
            .resideInAPackage("io.github.apsis.scenes..")
            .and()
            .resideOutsideOfPackage("io.github.apsis.scenes.shape..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.locationtech.jts..");

    /** The last bit of Math.sin may differ between machines; that of StrictMath.sin may not. */
    private static final ArchRule SAME_BITS_EVERYWHERE = noClasses()
            .that()
            .resideInAPackage("io.github.apsis.scenes..")
            .should()
            .callMethodWhere(describe(
                    "calls an inexact function of java.lang.Math",
                    (JavaCall<?> call) -> call.getTargetOwner().isEquivalentTo(Math.class)
                            && INEXACT.contains(call.getTarget().getName())));

    private final JavaClasses main = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("io.github.apsis.scenes");

    private final JavaClasses offenders = new ClassFileImporter().importClasses(Offender.class);

    @Test
    void scenes_know_only_the_engine() {
        SCENES_KNOW_ONLY_THE_ENGINE.check(main);

        assertFails(SCENES_KNOW_ONLY_THE_ENGINE);
    }

    @Test
    void only_the_shape_package_knows_jts() {
        JTS_STAYS_IN_SHAPE.check(main);

        assertFails(JTS_STAYS_IN_SHAPE);
    }

    @Test
    void no_scene_asks_math_for_what_differs_between_machines() {
        SAME_BITS_EVERYWHERE.check(main);

        assertFails(SAME_BITS_EVERYWHERE);
    }

    /** A rule that cannot fail proves nothing. */
    private void assertFails(ArchRule rule) {
        assertThatThrownBy(() -> rule.check(offenders)).isInstanceOf(AssertionError.class);
    }

    /** Breaks every rule of this class. */
    static final class Offender {
        private final JavaClass foreign;
        private final Coordinate jts = new Coordinate(Math.sin(1), 0);

        Offender(JavaClass foreign) {
            this.foreign = foreign;
        }

        @Override
        public String toString() {
            return foreign + " " + jts;
        }
    }
}
