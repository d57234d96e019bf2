package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.spatial.Workspace;
import org.jspecify.annotations.Nullable;

/**
 * Finds the contacts that the present paths lead to: bounces go into the queue, what is too gentle to bounce onto the list of
 * contacts at rest.
 */
final class ImpactPredictor {
    /** A gap below this share of the radii is none. */
    static final double CLOSED = 1e-7;

    /** Neighbours were looked for so far beyond the end of a path, as a share of the radius. */
    private static final double ALREADY_NEAR = 1e-3;

    private final @Nullable BroadPhase broadPhase;
    private final @Nullable WallSet walls;
    private final @Nullable Period period;
    private final Paths paths;
    private final Approach approach;
    private final ImpactQueue queue;
    private final Touching touching;
    private final LyingHeaps lying;
    private final Meeting meeting;
    private final ContactMode mode;
    private final PairIndex hopping = new PairIndex(); // come to rest in this tick
    private final int[] close = new int[256]; // numbers of pairs
    private final PairList gentle = new PairList(); // found since the last were listed
    private final Workspace workspace;
    private double mostAcceleration; // of any body in this tick, or more
    private final int mostImpacts; // of one body in a tick; what comes after is at rest

    ImpactPredictor(
            @Nullable BroadPhase broadPhase,
            @Nullable WallSet walls,
            @Nullable Period period,
            Paths paths,
            Approach approach,
            ImpactQueue queue,
            Touching touching,
            LyingHeaps lying,
            ContactMode mode,
            int mostImpacts,
            Workspace workspace) {
        this.broadPhase = broadPhase;
        this.walls = walls;
        this.period = period;
        this.paths = paths;
        this.approach = approach;
        this.queue = queue;
        this.touching = touching;
        this.lying = lying;
        this.mode = mode;
        this.mostImpacts = mostImpacts;
        this.workspace = workspace;
        this.meeting = new Meeting(paths, period, mode);
    }

    /** Looks along the paths of all bodies, as the integrator has drawn them. */
    void predictAll(Bodies bodies) {
        queue.clear();
        touching.begin(bodies);
        lying.begin(bodies);
        if (!lying.areLeftAlone()) {
            recallLying(bodies);
        }
        hopping.clear();
        gentle.clear(bodies.count());
        if (walls != null) {
            predictAllWalls(bodies, walls);
        }
        if (broadPhase != null) {
            broadPhase.build(bodies, paths);
            mostAcceleration = broadPhase.mostAcceleration();
            predictPairs(bodies, broadPhase, broadPhase.findPairs());
        }
        listGentle(bodies);
    }

    /** The contacts of the heaps that lie are those of the last tick, so they need not be found to be listed. */
    private void recallLying(Bodies bodies) {
        for (int k = 0; k < lying.contacts(); k++) {
            int a = lying.first(k);
            int b = lying.second(k);
            approach.locate(bodies, a, b, beginning(a, b));
            touching.recall(bodies, a, b, approach.contact(), lying.holding(k), lying.settling(k));
        }
        lying.forget(bodies);
    }

    private void predictAllWalls(Bodies bodies, WallSet set) {
        if (mode == ContactMode.EXACT) {
            for (int i = 0; i < bodies.count(); i++) {
                if (!lying.contains(i)) {
                    predictWalls(bodies, i);
                }
            }
            return;
        }
        workspace.take(this);
        double[] gaps = workspace.doubles(0, bodies.count());
        set.findGaps(bodies, gaps);
        for (int i = nextClosed(gaps, 0, bodies.count());
                i < bodies.count();
                i = nextClosed(gaps, i + 1, bodies.count())) {
            if (!lying.contains(i)) {
                predictWalls(bodies, i);
            }
        }
    }

    private static int nextClosed(double[] gaps, int from, int to) {
        int i = from;
        while (i < to && gaps[i] > 0) {
            i++;
        }
        return i;
    }

    private void predictPairs(Bodies bodies, BroadPhase near, int pairs) {
        boolean anyMayMeet = mode == ContactMode.EXACT || period != null;
        if (anyMayMeet || lying.areLeftAlone()) {
            double most = mostAcceleration * paths.dt() * paths.dt();
            for (int k = 0; k < pairs; k++) {
                int a = near.first(k);
                int b = near.second(k);
                if (!(lying.contains(a) && lying.contains(b)) && (anyMayMeet || areClose(bodies, a, b, most))) {
                    predict(bodies, a, b);
                }
            }
            return;
        }
        for (int from = 0; from < pairs; from += close.length) {
            int found = findClose(bodies, near, from, Math.min(pairs, from + close.length));
            for (int k = 0; k < found; k++) {
                predict(bodies, near.first(close[k]), near.second(close[k]));
            }
        }
    }

    /** Leaves out the pairs that are not close, which are most. No branch here depends on what is found, for none could be foretold. */
    private int findClose(Bodies bodies, BroadPhase near, int from, int to) {
        double most = mostAcceleration * paths.dt() * paths.dt();
        int found = 0;
        for (int k = from; k < to; k++) {
            close[found] = k;
            found += areClose(bodies, near.first(k), near.second(k), most) ? 1 : 0;
        }
        return found;
    }

    /** Whether two meet on straight ways through the tick, or end near each other. */
    private boolean areClose(Bodies bodies, int a, int b, double most) {
        double sumOfRadii = bodies.radius(a) + bodies.radius(b);
        double d0x = paths.startX(b) - paths.startX(a);
        double d0y = paths.startY(b) - paths.startY(a);
        double d1x = bodies.x(b) - bodies.x(a);
        double d1y = bodies.y(b) - bodies.y(a);
        return TimeOfImpact.mayTouch(d0x, d0y, d1x - d0x, d1y - d0y, sumOfRadii)
                | !Meeting.isBeyond(d1x, d1y, sumOfRadii + most);
    }

    /** A path has been bent. */
    void update(Bodies bodies, int i) {
        if (broadPhase != null) {
            broadPhase.update(bodies, paths, i);
        }
    }

    /** Two partners have come to rest within the tick, and meet again when it ends. */
    void hop(Bodies bodies, int a, int b) {
        hopping.put(a, b, 0);
        rest(bodies, a, b);
    }

    /** Looks along the path of one body from its last impact on, for everything but the partner of that impact. */
    void predictNext(Bodies bodies, int i, int partner) {
        if (bodies.isFixed(i)) {
            return;
        }
        predictWalls(bodies, i);
        if (broadPhase == null) {
            return;
        }
        int hits = broadPhase.findNear(i);
        for (int hit = 0; hit < hits; hit++) {
            int other = broadPhase.near(hit);
            if (other != i && other != partner) {
                predict(bodies, Math.min(i, other), Math.max(i, other));
            }
        }
        listGentle(bodies);
    }

    /**
     * Lists what bodies have been held off into: others, and walls, that were not in their way before.
     *
     * @param held where they ended before they were held
     * @return whether there is any
     */
    boolean findIntruders(Bodies bodies, HeldBodies held) {
        int before = touching.size();
        int k = 0;
        for (int i = held.next(0); i >= 0; i = held.next(i + 1), k++) {
            double dx = bodies.x(i) - held.x(k);
            double dy = bodies.y(i) - held.y(k);
            double near = ALREADY_NEAR * bodies.radius(i) + Paths.acceleration(bodies, i, -1) * paths.dt() * paths.dt();
            if (dx * dx + dy * dy > near * near) {
                update(bodies, i);
                intrude(bodies, i);
            }
        }
        listGentle(bodies);
        limitFirstOverlaps(bodies, before);
        return touching.size() > before;
    }

    /**
     * What holds a body moves its whole path, so where its partner's begins late, after a bounce, they may be deep in each other there though
     * they never were: no deeper than where both paths begin.
     */
    private void limitFirstOverlaps(Bodies bodies, int before) {
        if (touching.size() < RestingContacts.CROWD) {
            return;
        }
        ContactGeometry beginnings = approach.contact();
        for (int k = before; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            if (b >= 0 && !touching.isRecalled(k) && RestingContacts.isDeep(bodies, a, b, touching.firstGap(k))) {
                beginnings.fill(bodies, a, paths.startX(a), paths.startY(a), b, paths.startX(b), paths.startY(b));
                touching.limitFirstOverlap(k, Math.min(0, beginnings.gap));
            }
        }
    }

    private void intrude(Bodies bodies, int i) {
        for (int wall = -1; walls != null && wall > walls.end(); wall--) {
            if (walls.gap(wall, bodies.x(i), bodies.y(i), bodies.radius(i)) < 0) {
                rest(bodies, i, wall);
            }
        }
        int hits = broadPhase == null ? 0 : broadPhase.findNear(i);
        for (int hit = 0; hit < hits; hit++) {
            int a = Math.min(i, near(hit));
            int b = Math.max(i, near(hit));
            double sumOfRadii = bodies.radius(a) + bodies.radius(b);
            if (a != b && sumOfRadii > 0) {
                meeting.of(bodies, a, b);
                if (meeting.lastDistance() < sumOfRadii * (1 - CLOSED)) {
                    listLater(bodies, a, b);
                }
            }
        }
    }

    private int near(int hit) {
        return broadPhase == null ? -1 : broadPhase.near(hit);
    }

    /** Whether two who part in an impact may meet again in the tick: nobody does where no path is curved. */
    boolean mayMeetAgain() {
        return mostAcceleration > 0 || period != null;
    }

    /** Looks whether two bodies meet on the paths that an impact between them has left. */
    void predictAgain(Bodies bodies, int a, int b) {
        predict(bodies, a, b);
        listGentle(bodies);
    }

    private void predict(Bodies bodies, int a, int b) {
        double sumOfRadii = bodies.radius(a) + bodies.radius(b);
        if (sumOfRadii == 0 || bodies.isFixed(a) && bodies.isFixed(b) || hopping.find(a, b) >= 0) {
            return; // points never touch, and their contact would have no normal
        }
        meeting.of(bodies, a, b);
        if (mode == ContactMode.TICK && period == null && approach.isGentleAlways(bodies, a, b)) {
            if (endsNear(bodies, a, b, sumOfRadii) || meeting.touches(bodies, sumOfRadii)) {
                listLater(bodies, a, b); // by far the usual case in a heap, and nobody asks when
            }
            return;
        }
        double t = meeting.time(bodies, sumOfRadii);
        if (!Double.isNaN(t)) {
            enqueue(bodies, a, b, t);
        } else if (endsNear(bodies, a, b, sumOfRadii)) {
            listLater(
                    bodies, a,
                    b); // a neighbour that is stopped in this tick may be run into by one that falls beside it
        }
    }

    /** Whether two end the tick within the way that their acceleration would push them in it. */
    private boolean endsNear(Bodies bodies, int a, int b, double sumOfRadii) {
        double tick2 = paths.dt() * paths.dt();
        if (meeting.endsBeyond(sumOfRadii + mostAcceleration * tick2)) {
            return false; // by far the usual case, without a root
        }
        double last = meeting.lastDistance();
        return last < sumOfRadii + mostAcceleration * tick2
                && last < sumOfRadii + Paths.acceleration(bodies, a, b) * tick2;
    }

    private void predictWalls(Bodies bodies, int i) {
        if (walls == null || mode == ContactMode.TICK && walls.contains(bodies, i, 0) || bodies.isFixed(i)) {
            return;
        }
        if (mode == ContactMode.EXACT) {
            predictWallsExactly(bodies, walls, i);
            return;
        }
        double t0 = paths.startTime(i);
        double r = bodies.radius(i);
        for (int wall = -1; wall > walls.end(); wall--) {
            double gap0 = walls.gap(wall, paths.startX(i), paths.startY(i), r);
            double gap1 = walls.gap(wall, bodies.x(i), bodies.y(i), r);
            if (gap1 > 0) {
                continue;
            }
            double inwards = Paths.accelerationX(bodies, i) * walls.normalX(wall)
                    + Paths.accelerationY(bodies, i) * walls.normalY(wall);
            double speed =
                    paths.vxAt(bodies, i, t0) * walls.normalX(wall) + paths.vyAt(bodies, i, t0) * walls.normalY(wall);
            double t = TimeOfImpact.ofWall(gap0, gap1, speed, inwards, t0, paths.dt());
            enqueue(bodies, i, wall, t);
        }
    }

    private void predictWallsExactly(Bodies bodies, WallSet set, int i) {
        if (set.contains(bodies, i, paths.bulge(bodies, i))) {
            return;
        }
        double r = bodies.radius(i);
        double size = r + Math.abs(bodies.x(i)) + Math.abs(bodies.y(i));
        for (int wall = -1; wall > set.end(); wall--) {
            double gap0 = set.gap(wall, paths.startX(i), paths.startY(i), r);
            double gap1 = set.gap(wall, bodies.x(i), bodies.y(i), r);
            double inwards = Paths.accelerationX(bodies, i) * set.normalX(wall)
                    + Paths.accelerationY(bodies, i) * set.normalY(wall);
            if (hopping.find(i, wall) >= 0) {
                continue;
            }
            double t = FirstTouch.ofWall(gap0, gap1, inwards, paths.startTime(i), paths.dt(), size);
            if (gap1 <= 0 || !Double.isNaN(t)) {
                enqueue(bodies, i, wall, t);
            }
        }
    }

    /**
     * Queues an impact at time t, or lists a contact at rest: one that closes gently, and a body
     * that is beyond a wall and on its way back, for which t is NaN.
     */
    private void enqueue(Bodies bodies, int a, int b, double t) {
        wake(bodies, a, b);
        if (Double.isNaN(t) || paths.mostImpacts(a, b) >= mostImpacts || isAtRest(bodies, a, b, t) && !mayHop(a, b)) {
            if (b < 0) {
                rest(bodies, a, b);
            } else {
                listLater(bodies, a, b);
            }
        } else {
            queue.push(t, a, b, paths.impacts(a), paths.impacts(b));
        }
    }

    /** Another that touches one of those that lie wakes them all. */
    private void wake(Bodies bodies, int a, int b) {
        if (lying.containsFree(bodies, a) || lying.containsFree(bodies, b)) {
            recallLying(bodies);
        }
    }

    private void listLater(Bodies bodies, int a, int b) {
        wake(bodies, a, b);
        gentle.add(a, b);
    }

    private boolean isAtRest(Bodies bodies, int a, int b, double t) {
        if (b >= 0 && period == null) {
            double closing = meeting.closingSpeed(bodies, t, bodies.radius(a) + bodies.radius(b));
            if (approach.isSurelyBounce(bodies, a, b, closing, mostAcceleration)) {
                return false; // by far the usual case in a gas
            }
        }
        approach.measure(bodies, a, b, t);
        return approach.isGentle(bodies, a, b);
    }

    /** An exact contact that comes to rest within the tick ends with a hop; what was at rest before is held from its beginning. */
    private boolean mayHop(int a, int b) {
        return mode == ContactMode.EXACT && paths.mostImpacts(a, b) > 0 && approach.closingSpeed() > 0;
    }

    private void listGentle(Bodies bodies) {
        if (gentle.size() > 0) {
            gentle.sort();
            for (int k = 0; k < gentle.size(); k++) {
                rest(bodies, gentle.first(k), gentle.second(k));
            }
            gentle.clear(bodies.count());
        }
    }

    /** Lists a contact as it is where the later of the two paths begins. */
    private void rest(Bodies bodies, int a, int b) {
        approach.locate(bodies, a, b, beginning(a, b));
        if (approach.contact().inverseMass > 0) {
            touching.add(a, b, approach.contact());
        }
    }

    private double beginning(int a, int b) {
        return b < 0 ? paths.startTime(a) : Math.max(paths.startTime(a), paths.startTime(b));
    }
}
