package io.github.apsis.engine.force;

import static java.lang.Math.fma;

/**
 * Cartesian expansions of φ(r) = 1/√(r² + ε²) in the plane, for cells of bodies: the mathematics of {@link TreeGravity}.
 *
 * <pre>
 *   M_ab = Σ_j m_j X_j^a Y_j^b / (a! b!)                 moments of the bodies of a cell about its centre of mass
 *   L_kl = Σ_ab (−1)^(a+b) M_ab ∂x^(k+a) ∂y^(l+b) φ(R)   what another cell at −R does, up to k + l + a + b = ORDER
 *   a/G  = Σ_kl (L_(k+1)l, L_k(l+1)) X^k Y^l / (k! l!)   the pull on a body of the cell
 * </pre>
 *
 * <p>As Dehnen 2002 (J. Comput. Phys. 179, 27), with dipoles: they vanish about a centre of mass, but not about its rounded
 * place, and a world far from the origin would feel it. Both cells of a pair are served by one set of derivatives cut at
 * the same order, so that what one gains in momentum the other loses, to rounding. The coefficient of x^a y^b stands at
 * n (n + 1) / 2 + b, n = a + b. Kernels that run per pair and per body are written out; loops took twice the time.
 *
 * <p>The moments stand in a {@link MassTree}, the locals in a {@link CellWalk}; all threads may work with one.
 */
final class CellKernels {
    static final int ORDER = 6;

    /** Coefficients of a cell that pulls; moments have orders below ORDER. */
    static final int MOMENTS = ORDER * (ORDER + 1) / 2;

    /** Coefficients of what pulls a cell. */
    static final int LOCALS = (ORDER + 1) * (ORDER + 2) / 2;

    private final double softeningSquared; // length²
    private double[] moment = new double[0];

    CellKernels(double softening) {
        this.softeningSquared = softening * softening;
    }

    /** Works on the moments of these cells from now on. */
    void use(double[] momentsOfCells) {
        moment = momentsOfCells;
    }

    /** Adds a body at this place relative to the centre of the cell. */
    void addBody(int cell, double m, double x, double y) {
        double mx = m * x;
        double mx2 = mx * x * (1.0 / 2);
        double mx3 = mx2 * x * (1.0 / 3);
        double mx4 = mx3 * x * (1.0 / 4);
        double mx5 = mx4 * x * (1.0 / 5);
        double y2 = y * y * (1.0 / 2);
        double y3 = y2 * y * (1.0 / 3);
        double y4 = y3 * y * (1.0 / 4);
        double y5 = y4 * y * (1.0 / 5);
        int at = cell * MOMENTS;
        moment[at] += m;
        moment[at + 1] += mx;
        moment[at + 2] = fma(m, y, moment[at + 2]);
        moment[at + 3] += mx2;
        moment[at + 4] = fma(mx, y, moment[at + 4]);
        moment[at + 5] = fma(m, y2, moment[at + 5]);
        moment[at + 6] += mx3;
        moment[at + 7] = fma(mx2, y, moment[at + 7]);
        moment[at + 8] = fma(mx, y2, moment[at + 8]);
        moment[at + 9] = fma(m, y3, moment[at + 9]);
        moment[at + 10] += mx4;
        moment[at + 11] = fma(mx3, y, moment[at + 11]);
        moment[at + 12] = fma(mx2, y2, moment[at + 12]);
        moment[at + 13] = fma(mx, y3, moment[at + 13]);
        moment[at + 14] = fma(m, y4, moment[at + 14]);
        moment[at + 15] += mx5;
        moment[at + 16] = fma(mx4, y, moment[at + 16]);
        moment[at + 17] = fma(mx3, y2, moment[at + 17]);
        moment[at + 18] = fma(mx2, y3, moment[at + 18]);
        moment[at + 19] = fma(mx, y4, moment[at + 19]);
        moment[at + 20] = fma(m, y5, moment[at + 20]);
    }

    /** Adds the moments of a child, whose centre lies here relative to that of the parent. */
    void addChild(int parent, int child, double x, double y) {
        Shifts.addMoments(moment, child * MOMENTS, parent * MOMENTS, x, y);
    }

    /**
     * Lets the cell of a row of locals be pulled by another; (x, y) leads from the centre of the source to its own.
     *
     * <p>All derivatives of φ at (x, y), orders 1 to ORDER, by the recurrence that follows from s ∂xφ = −x φ, s = r² + ε²:
     *
     * <pre>
     *   s D_ab = −(2a−1) x D_(a−1)b − (a−1)² D_(a−2)b − 2b y D_a(b−1) − b (b−1) D_a(b−2)
     * </pre>
     *
     * <p>in units of √s, so that nothing overflows on the way. Handed over in an array they made
     * a tree of 10 000 at θ = 0.5 a twelfth slower.
     */
    void pull(double[] local, int target, int source, double x, double y) {
        double h = 1 / Math.sqrt(fma(x, x, fma(y, y, softeningSquared)));
        double u = -h * x;
        double v = -h * y;
        double p10 = u;
        double p01 = v;
        double p20 = 3 * u * p10 - 1;
        double p11 = u * p01 + 2 * v * p10;
        double p02 = 3 * v * p01 - 1;
        double p30 = 5 * u * p20 - 4 * p10;
        double p21 = 3 * u * p11 + 2 * v * p20 - p01;
        double p12 = u * p02 + 4 * v * p11 - 2 * p10;
        double p03 = 5 * v * p02 - 4 * p01;
        double p40 = 7 * u * p30 - 9 * p20;
        double p31 = 5 * u * p21 + 2 * v * p30 - 4 * p11;
        double p22 = 3 * u * p12 + 4 * v * p21 - p02 - 2 * p20;
        double p13 = u * p03 + 6 * v * p12 - 6 * p11;
        double p04 = 7 * v * p03 - 9 * p02;
        double p50 = 9 * u * p40 - 16 * p30;
        double p41 = 7 * u * p31 + 2 * v * p40 - 9 * p21;
        double p32 = 5 * u * p22 + 4 * v * p31 - 4 * p12 - 2 * p30;
        double p23 = 3 * u * p13 + 6 * v * p22 - p03 - 6 * p21;
        double p14 = u * p04 + 8 * v * p13 - 12 * p12;
        double p05 = 9 * v * p04 - 16 * p03;
        double p60 = 11 * u * p50 - 25 * p40;
        double p51 = 9 * u * p41 + 2 * v * p50 - 16 * p31;
        double p42 = 7 * u * p32 + 4 * v * p41 - 9 * p22 - 2 * p40;
        double p33 = 5 * u * p23 + 6 * v * p32 - 4 * p13 - 6 * p31;
        double p24 = 3 * u * p14 + 8 * v * p23 - p04 - 12 * p22;
        double p15 = u * p05 + 10 * v * p14 - 20 * p13;
        double p06 = 11 * v * p05 - 25 * p04;
        double scale = h;
        scale *= h;
        double d10 = scale * p10;
        double d01 = scale * p01;
        scale *= h;
        double d20 = scale * p20;
        double d11 = scale * p11;
        double d02 = scale * p02;
        scale *= h;
        double d30 = scale * p30;
        double d21 = scale * p21;
        double d12 = scale * p12;
        double d03 = scale * p03;
        scale *= h;
        double d40 = scale * p40;
        double d31 = scale * p31;
        double d22 = scale * p22;
        double d13 = scale * p13;
        double d04 = scale * p04;
        scale *= h;
        double d50 = scale * p50;
        double d41 = scale * p41;
        double d32 = scale * p32;
        double d23 = scale * p23;
        double d14 = scale * p14;
        double d05 = scale * p05;
        scale *= h;
        double d60 = scale * p60;
        double d51 = scale * p51;
        double d42 = scale * p42;
        double d33 = scale * p33;
        double d24 = scale * p24;
        double d15 = scale * p15;
        double d06 = scale * p06;
        int from = source * MOMENTS;
        int to = target * LOCALS;
        double m00 = moment[from];
        double m10 = -moment[from + 1];
        double m01 = -moment[from + 2];
        double m20 = moment[from + 3];
        double m11 = moment[from + 4];
        double m02 = moment[from + 5];
        double m30 = -moment[from + 6];
        double m21 = -moment[from + 7];
        double m12 = -moment[from + 8];
        double m03 = -moment[from + 9];
        double m40 = moment[from + 10];
        double m31 = moment[from + 11];
        double m22 = moment[from + 12];
        double m13 = moment[from + 13];
        double m04 = moment[from + 14];
        double m50 = -moment[from + 15];
        double m41 = -moment[from + 16];
        double m32 = -moment[from + 17];
        double m23 = -moment[from + 18];
        double m14 = -moment[from + 19];
        double m05 = -moment[from + 20];
        local[to + 1] += m00 * d10
                + fma(m10, d20, m01 * d11)
                + fma(m20, d30, fma(m11, d21, m02 * d12))
                + fma(m30, d40, fma(m21, d31, fma(m12, d22, m03 * d13)))
                + fma(m40, d50, fma(m31, d41, fma(m22, d32, fma(m13, d23, m04 * d14))))
                + fma(m50, d60, fma(m41, d51, fma(m32, d42, fma(m23, d33, fma(m14, d24, m05 * d15)))));
        local[to + 2] += m00 * d01
                + fma(m10, d11, m01 * d02)
                + fma(m20, d21, fma(m11, d12, m02 * d03))
                + fma(m30, d31, fma(m21, d22, fma(m12, d13, m03 * d04)))
                + fma(m40, d41, fma(m31, d32, fma(m22, d23, fma(m13, d14, m04 * d05))))
                + fma(m50, d51, fma(m41, d42, fma(m32, d33, fma(m23, d24, fma(m14, d15, m05 * d06)))));
        local[to + 3] += m00 * d20
                + fma(m10, d30, m01 * d21)
                + fma(m20, d40, fma(m11, d31, m02 * d22))
                + fma(m30, d50, fma(m21, d41, fma(m12, d32, m03 * d23)))
                + fma(m40, d60, fma(m31, d51, fma(m22, d42, fma(m13, d33, m04 * d24))));
        local[to + 4] += m00 * d11
                + fma(m10, d21, m01 * d12)
                + fma(m20, d31, fma(m11, d22, m02 * d13))
                + fma(m30, d41, fma(m21, d32, fma(m12, d23, m03 * d14)))
                + fma(m40, d51, fma(m31, d42, fma(m22, d33, fma(m13, d24, m04 * d15))));
        local[to + 5] += m00 * d02
                + fma(m10, d12, m01 * d03)
                + fma(m20, d22, fma(m11, d13, m02 * d04))
                + fma(m30, d32, fma(m21, d23, fma(m12, d14, m03 * d05)))
                + fma(m40, d42, fma(m31, d33, fma(m22, d24, fma(m13, d15, m04 * d06))));
        local[to + 6] += m00 * d30
                + fma(m10, d40, m01 * d31)
                + fma(m20, d50, fma(m11, d41, m02 * d32))
                + fma(m30, d60, fma(m21, d51, fma(m12, d42, m03 * d33)));
        local[to + 7] += m00 * d21
                + fma(m10, d31, m01 * d22)
                + fma(m20, d41, fma(m11, d32, m02 * d23))
                + fma(m30, d51, fma(m21, d42, fma(m12, d33, m03 * d24)));
        local[to + 8] += m00 * d12
                + fma(m10, d22, m01 * d13)
                + fma(m20, d32, fma(m11, d23, m02 * d14))
                + fma(m30, d42, fma(m21, d33, fma(m12, d24, m03 * d15)));
        local[to + 9] += m00 * d03
                + fma(m10, d13, m01 * d04)
                + fma(m20, d23, fma(m11, d14, m02 * d05))
                + fma(m30, d33, fma(m21, d24, fma(m12, d15, m03 * d06)));
        local[to + 10] += m00 * d40 + fma(m10, d50, m01 * d41) + fma(m20, d60, fma(m11, d51, m02 * d42));
        local[to + 11] += m00 * d31 + fma(m10, d41, m01 * d32) + fma(m20, d51, fma(m11, d42, m02 * d33));
        local[to + 12] += m00 * d22 + fma(m10, d32, m01 * d23) + fma(m20, d42, fma(m11, d33, m02 * d24));
        local[to + 13] += m00 * d13 + fma(m10, d23, m01 * d14) + fma(m20, d33, fma(m11, d24, m02 * d15));
        local[to + 14] += m00 * d04 + fma(m10, d14, m01 * d05) + fma(m20, d24, fma(m11, d15, m02 * d06));
        local[to + 15] += m00 * d50 + fma(m10, d60, m01 * d51);
        local[to + 16] += m00 * d41 + fma(m10, d51, m01 * d42);
        local[to + 17] += m00 * d32 + fma(m10, d42, m01 * d33);
        local[to + 18] += m00 * d23 + fma(m10, d33, m01 * d24);
        local[to + 19] += m00 * d14 + fma(m10, d24, m01 * d15);
        local[to + 20] += m00 * d05 + fma(m10, d15, m01 * d06);
        local[to + 21] += m00 * d60;
        local[to + 22] += m00 * d51;
        local[to + 23] += m00 * d42;
        local[to + 24] += m00 * d33;
        local[to + 25] += m00 * d24;
        local[to + 26] += m00 * d15;
        local[to + 27] += m00 * d06;
    }

    /** Hands the pull on a parent down to the row of a child, whose centre lies here relative to that of the parent. */
    void passDown(double[] local, int parent, int child, double x, double y) {
        Shifts.addLocals(local, parent * LOCALS, child * LOCALS, x, y);
    }

    /** Lets all that pulls a cell from afar pull a body at this place relative to its centre. */
    void passToBody(double[] local, int cell, Pulls pulls, int body, double x, double y) {
        double x2 = x * x * (1.0 / 2);
        double x3 = x2 * x * (1.0 / 3);
        double x4 = x3 * x * (1.0 / 4);
        double x5 = x4 * x * (1.0 / 5);
        double y2 = y * y * (1.0 / 2);
        double y3 = y2 * y * (1.0 / 3);
        double y4 = y3 * y * (1.0 / 4);
        double y5 = y4 * y * (1.0 / 5);
        int at = cell * LOCALS;
        double ax0 = local[at + 1]
                + fma(y, local[at + 4], y2 * local[at + 8])
                + fma(y3, local[at + 13], fma(y4, local[at + 19], y5 * local[at + 26]));
        double ax1 = local[at + 3]
                + fma(y, local[at + 7], y2 * local[at + 12])
                + fma(y3, local[at + 18], y4 * local[at + 25]);
        double ax2 = local[at + 6] + fma(y, local[at + 11], fma(y2, local[at + 17], y3 * local[at + 24]));
        double ax3 = local[at + 10] + fma(y, local[at + 16], y2 * local[at + 23]);
        double ax4 = fma(y, local[at + 22], local[at + 15]);
        double ax5 = local[at + 21];
        double ay0 = local[at + 2]
                + fma(y, local[at + 5], y2 * local[at + 9])
                + fma(y3, local[at + 14], fma(y4, local[at + 20], y5 * local[at + 27]));
        double ay1 = local[at + 4]
                + fma(y, local[at + 8], y2 * local[at + 13])
                + fma(y3, local[at + 19], y4 * local[at + 26]);
        double ay2 = local[at + 7] + fma(y, local[at + 12], fma(y2, local[at + 18], y3 * local[at + 25]));
        double ay3 = local[at + 11] + fma(y, local[at + 17], y2 * local[at + 24]);
        double ay4 = fma(y, local[at + 23], local[at + 16]);
        double ay5 = local[at + 22];
        pulls.add(
                body,
                fma(x5, ax5, fma(x4, ax4, fma(x3, ax3, fma(x2, ax2, fma(x, ax1, ax0))))),
                fma(x5, ay5, fma(x4, ay4, fma(x3, ay3, fma(x2, ay2, fma(x, ay1, ay0))))));
    }
}
