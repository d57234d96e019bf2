package io.github.apsis.protocol;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.lang.ArchRule;
import org.junit.jupiter.api.Test;

class ArchitectureTest {
    private static final JavaClasses OURS = new ClassFileImporter()
            .withImportOption(new DoNotIncludeTests())
            .importPackages("io.github.apsis.protocol");

    @Test
    void the_messages_know_the_jdk_alone() {
        rule("io.github.apsis.protocol", "java..", "org.jspecify.annotations").check(OURS);
    }

    @Test
    void the_rule_notices_a_stranger() {
        assertThatThrownBy(() -> rule("io.github.apsis.protocol").check(OURS)).isInstanceOf(AssertionError.class);
    }

    private static ArchRule rule(String... allowed) {
        return classes().should().onlyDependOnClassesThat().resideInAnyPackage(allowed);
    }
}
