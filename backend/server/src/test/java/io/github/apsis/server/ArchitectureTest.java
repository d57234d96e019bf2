package io.github.apsis.server;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.lang.ArchRule;
import org.junit.jupiter.api.Test;

class ArchitectureTest {
    private static final JavaClasses OURS =
            new ClassFileImporter().withImportOption(new DoNotIncludeTests()).importPackages("io.github.apsis.server");

    @Test
    void a_room_knows_the_engine_the_scenes_and_the_jdk() {
        plain("io.github.apsis.server.room").check(OURS);
    }

    @Test
    void the_rule_can_fail() {
        assertThat(plain("io.github.apsis.server.web").evaluate(OURS).hasViolation())
                .isTrue();
    }

    @Test
    void nobody_keeps_state_in_statics() {
        fields().that().areStatic().should().beFinal().check(OURS);
    }

    @Test
    void nobody_prints() {
        noClasses()
                .should()
                .accessField(System.class, "out")
                .orShould()
                .accessField(System.class, "err")
                .check(OURS);
    }

    private static ArchRule plain(String where) {
        return classes()
                .that()
                .resideInAPackage(where)
                .should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage(
                        "io.github.apsis.server.room",
                        "io.github.apsis.engine..",
                        "io.github.apsis.scenes..",
                        "java..",
                        "org.slf4j",
                        "lombok", // its mark on what it has generated
                        "org.jspecify.annotations");
    }
}
