package io.github.apsis.engine;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Who may import whom inside the engine. Plain tests: rules in {@code @ArchTest} fields are skipped without a word. */
class ArchitectureTest {
    private static final String ENGINE = "io.github.apsis.engine";
    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages(ENGINE);

    @ParameterizedTest
    @CsvSource({
        "math, ''",
        "parallel, ''",
        "body, 'math'",
        "spatial, 'body math parallel'",
        "force, 'body spatial math parallel'",
        "steering, 'body spatial math parallel'",
        "integration, 'force body math'",
        "collision, 'body spatial math parallel'",
        "stepping, 'integration collision force body spatial math parallel'",
        "diagnostics, 'force body spatial math'"
    })
    void a_package_imports_only_what_stands_below_it(String name, String allowed) {
        rule(name, allowed).check(CLASSES);
    }

    @Test
    void the_rule_notices_an_import_that_points_up() {
        // Integration really imports force: a rule that forbids it must fail, or the rules above prove nothing.
        assertThatThrownBy(() -> rule("integration", "body math").check(CLASSES))
                .isInstanceOf(AssertionError.class);
    }

    @Test
    void the_engine_reads_no_clock_and_knows_no_framework() {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.time..", "java.io..", "java.net..", "java.util.logging..")
                .orShould()
                .callMethod(System.class, "nanoTime")
                .orShould()
                .callMethod(System.class, "currentTimeMillis")
                .check(CLASSES);
    }

    private static ArchRule rule(String name, String allowed) {
        List<String> packages = new ArrayList<>(List.of("java..", "org.jspecify.annotations", ENGINE + "." + name));
        Arrays.stream(allowed.split(" "))
                .filter(s -> !s.isEmpty())
                .map(s -> ENGINE + "." + s)
                .forEach(packages::add);
        return classes()
                .that()
                .resideInAPackage(ENGINE + "." + name)
                .should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage(packages.toArray(String[]::new));
    }
}
