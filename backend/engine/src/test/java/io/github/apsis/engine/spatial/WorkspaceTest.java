package io.github.apsis.engine.spatial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.apsis.engine.parallel.Team;
import org.junit.jupiter.api.Test;

class WorkspaceTest {
    private final Workspace workspace = new Workspace();

    @Test
    void parts_that_follow_each_other_share_a_column() {
        double[] ofOne = workspace.doubles(0, 100);

        assertThat(workspace.doubles(0, 80)).isSameAs(ofOne);
        assertThat(workspace.doubles(0, 101)).isNotSameAs(ofOne).hasSizeGreaterThan(101);
    }

    @Test
    void circles_that_another_part_has_written_over_are_not_asked_for_pairs() {
        var grid = new CircleGrid(null, Team.ofOne(), workspace);
        grid.begin(2);
        grid.set(0, 0, 0, 1);
        grid.set(1, 1, 0, 1);
        grid.build();
        assertThat(grid.findPairs()).isEqualTo(1);

        Quadtree.ofPoints(8, Team.ofOne(), workspace).begin(2);

        assertThatThrownBy(grid::findPairs).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> grid.query(0)).isInstanceOf(IllegalStateException.class);
    }
}
