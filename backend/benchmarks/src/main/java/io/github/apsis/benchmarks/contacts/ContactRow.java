package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;

/** One line of {@code contacts.csv}; NaN where a case knows nothing to compare with. */
record ContactRow(
        String caseId,
        ContactMode mode,
        String eventsInOrder,
        double timeError,
        double positionError,
        double velocityError,
        double energyChange,
        double momentumError,
        String status) {
    static final String HEADER =
            "case,mode,events_in_order,max_time_error,max_position_error,max_velocity_error,energy_change,momentum_error,status";

    static ContactRow of(ContactCase known, ContactMode mode, ContactErrors errors, String status) {
        return new ContactRow(
                known.id(),
                mode,
                errors.order().cell(),
                errors.order().time().largest(),
                errors.position().largest(),
                errors.velocities().largest(),
                errors.energyChange(),
                errors.momentum(),
                status);
    }

    /** A row of a case of which only a status is known. */
    static ContactRow without(String caseId, ContactMode mode, String status) {
        double none = Double.NaN;
        return new ContactRow(caseId, mode, "", none, none, none, none, none, status);
    }

    boolean isBad() {
        return ContactVerdict.isBad(status);
    }

    String csv() {
        return Csv.line(
                caseId,
                mode.label(),
                eventsInOrder,
                Cells.exact(timeError),
                Cells.exact(positionError),
                Cells.exact(velocityError),
                Cells.exact(energyChange),
                Cells.exact(momentumError),
                status);
    }
}
