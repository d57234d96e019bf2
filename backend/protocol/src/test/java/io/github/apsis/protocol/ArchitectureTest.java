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

    private static final String MESSAGES = "io.github.apsis.protocol";
    private static final String CODEC = "io.github.apsis.protocol.json";

    @Test
    void the_messages_know_the_jdk_alone() {
        rule(MESSAGES, MESSAGES, "java..", "org.jspecify.annotations").check(OURS);
    }

    @Test
    void the_codec_knows_the_messages_and_a_writer_of_json() {
        rule(CODEC, CODEC, MESSAGES, "java..", "tools.jackson.core..", "org.jspecify.annotations")
                .check(OURS);
    }

    @Test
    void the_rules_notice_a_stranger() {
        assertThatThrownBy(() -> rule(MESSAGES, MESSAGES).check(OURS)).isInstanceOf(AssertionError.class);
        assertThatThrownBy(() -> rule(CODEC, CODEC, "java..").check(OURS)).isInstanceOf(AssertionError.class);
    }

    private static ArchRule rule(String of, String... allowed) {
        return classes()
                .that()
                .resideInAPackage(of)
                .should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage(allowed);
    }
}
