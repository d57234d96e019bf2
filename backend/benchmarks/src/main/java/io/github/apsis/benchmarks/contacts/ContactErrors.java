package io.github.apsis.benchmarks.contacts;

/**
 * How far a run strayed from a case.
 *
 * @param position relative to the length scale, of the samples and of the apexes
 * @param velocity relative to the velocity scale, of the samples
 * @param energyChange beyond what the bounces of the case take, relative to the largest kinetic energy; signed
 * @param energyGain the largest rise above any earlier moment, relative in the same way; never negative
 * @param momentum beyond what walls and fields gave, relative
 * @param apexHeights after each bounce; NaN where no tick fell between two
 */
record ContactErrors(
        boolean finite,
        EventOrder order,
        Peak position,
        Peak velocity,
        double energyChange,
        double energyGain,
        double momentum,
        double[] apexHeights) {
    /**
     * Of the samples; where there are none, of the closing speeds of bounces. Beside samples those prove nothing more, and of
     * two discs that only graze each other the closing speed amplifies what the place of either is off by.
     */
    Peak velocities() {
        return Double.isNaN(velocity.largest()) ? order.closing() : velocity;
    }
}
