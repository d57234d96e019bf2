package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.report.Cells;
import java.util.List;

/**
 * The bounces of a run held against those of a case, one by one: how many of the first came in the order of the case, and
 * when. Bounces that are closer in time than what counts as exact may come in either order.
 */
final class EventOrder {
    private final ContactCase known;
    private final List<ContactEvent> bounces;
    private final boolean[] met;
    private int inOrder;
    private String oddity = "";
    private final Peak time = new Peak();
    private final Peak closing = new Peak();

    EventOrder(ContactCase known, List<ContactEvent> bounces) {
        this.known = known;
        this.bounces = bounces;
        this.met = new boolean[known.events().size()];
        if (known.knowsEvents()) {
            compare();
        }
    }

    private void compare() {
        int head = 0;
        for (ContactEvent bounce : bounces) {
            while (head < met.length && met[head]) {
                head++;
            }
            if (head == met.length) {
                tooMany(bounce);
                return;
            }
            int which = partner(bounce, head);
            if (which < 0) {
                ContactEvent next = known.events().get(head);
                oddity = "bounce %d is of %s at t=%s and not of %s at %s"
                        .formatted(
                                inOrder + 1,
                                bounce.names(),
                                Cells.plain(bounce.time()),
                                next.names(),
                                Cells.plain(next.time()));
                return;
            }
            meet(bounce, which);
        }
        if (inOrder < met.length) {
            ContactEvent next = known.events().get(head(head));
            oddity = "bounce %d, of %s at t=%s, did not come"
                    .formatted(inOrder + 1, next.names(), Cells.plain(next.time()));
        }
    }

    private int head(int from) {
        int head = from;
        while (met[head]) {
            head++;
        }
        return head;
    }

    /** A case knows its bounces until its end, and nothing of what comes then. */
    private void tooMany(ContactEvent bounce) {
        if (bounce.time() < known.end() - known.limit(known.end())) {
            oddity = "a bounce of %s at t=%s is one too many".formatted(bounce.names(), Cells.plain(bounce.time()));
        }
    }

    private int partner(ContactEvent bounce, int head) {
        double latest = known.events().get(head).time();
        latest += known.limit(latest);
        for (int k = head; k < met.length && known.events().get(k).time() <= latest; k++) {
            if (!met[k] && known.events().get(k).isBetween(bounce)) {
                return k;
            }
        }
        return -1;
    }

    private void meet(ContactEvent bounce, int which) {
        ContactEvent event = known.events().get(which);
        met[which] = true;
        inOrder++;
        double limit = known.limit(event.time());
        time.add(Math.abs(bounce.time() - event.time()), limit, event.time());
        closing.add(
                Math.abs(bounce.closingSpeed() - event.closingSpeed()) / known.velocityScale(), limit, event.time());
    }

    int inOrder() {
        return inOrder;
    }

    /** {@code 471/471}; empty where the case does not list its bounces. */
    String cell() {
        return known.knowsEvents() ? inOrder + "/" + met.length : "";
    }

    /** What was not as the case says, first; empty when all was. */
    String oddity() {
        return oddity;
    }

    /** |t − t_ref| of the bounces in order. */
    Peak time() {
        return time;
    }

    /** |closing speed − that of the case| / velocity scale, of the bounces in order. */
    Peak closing() {
        return closing;
    }
}
