package io.github.apsis.engine.force;

import static java.lang.Math.fma;

/**
 * Moves the expansions of {@link CellKernels} to other centres, by (x, y):
 *
 * <pre>
 *   M'_ab = Σ_ij x^i y^j / (i! j!) M_(a−i)(b−j)     from the centre of a child, which lies at (x, y), to that of its parent
 *   L'_kl = Σ_ij x^i y^j / (i! j!) L_(k+i)(l+j)     from the centre of a parent to that of its child, which lies at (x, y)
 * </pre>
 *
 * <p>Along x and then along y, which takes 70 products and not 105 for moments, and 100 and not 155 for locals; written out, since
 * loops took eight times as long.
 */
final class Shifts {
    private Shifts() {}

    /** Adds the moments that begin at {@code child} to those that begin at {@code parent}. */
    static void addMoments(double[] moment, int child, int parent, double x, double y) {
        double x2 = x * x * (1.0 / 2);
        double x3 = x2 * x * (1.0 / 3);
        double x4 = x3 * x * (1.0 / 4);
        double x5 = x4 * x * (1.0 / 5);
        double y2 = y * y * (1.0 / 2);
        double y3 = y2 * y * (1.0 / 3);
        double y4 = y3 * y * (1.0 / 4);
        double y5 = y4 * y * (1.0 / 5);
        double m00 = moment[child];
        double m10 = moment[child + 1];
        double m20 = moment[child + 3];
        double m30 = moment[child + 6];
        double m40 = moment[child + 10];
        double m50 = moment[child + 15];
        m50 = fma(x5, m00, fma(x4, m10, fma(x3, m20, fma(x2, m30, fma(x, m40, m50)))));
        m40 = fma(x4, m00, fma(x3, m10, fma(x2, m20, fma(x, m30, m40))));
        m30 = fma(x3, m00, fma(x2, m10, fma(x, m20, m30)));
        m20 = fma(x2, m00, fma(x, m10, m20));
        m10 = fma(x, m00, m10);
        double m01 = moment[child + 2];
        double m11 = moment[child + 4];
        double m21 = moment[child + 7];
        double m31 = moment[child + 11];
        double m41 = moment[child + 16];
        m41 = fma(x4, m01, fma(x3, m11, fma(x2, m21, fma(x, m31, m41))));
        m31 = fma(x3, m01, fma(x2, m11, fma(x, m21, m31)));
        m21 = fma(x2, m01, fma(x, m11, m21));
        m11 = fma(x, m01, m11);
        double m02 = moment[child + 5];
        double m12 = moment[child + 8];
        double m22 = moment[child + 12];
        double m32 = moment[child + 17];
        m32 = fma(x3, m02, fma(x2, m12, fma(x, m22, m32)));
        m22 = fma(x2, m02, fma(x, m12, m22));
        m12 = fma(x, m02, m12);
        double m03 = moment[child + 9];
        double m13 = moment[child + 13];
        double m23 = moment[child + 18];
        m23 = fma(x2, m03, fma(x, m13, m23));
        m13 = fma(x, m03, m13);
        double m04 = moment[child + 14];
        double m14 = moment[child + 19];
        m14 = fma(x, m04, m14);
        double m05 = moment[child + 20];
        moment[parent] += m00;
        moment[parent + 1] += m10;
        moment[parent + 2] += fma(y, m00, m01);
        moment[parent + 3] += m20;
        moment[parent + 4] += fma(y, m10, m11);
        moment[parent + 5] += fma(y2, m00, fma(y, m01, m02));
        moment[parent + 6] += m30;
        moment[parent + 7] += fma(y, m20, m21);
        moment[parent + 8] += fma(y2, m10, fma(y, m11, m12));
        moment[parent + 9] += fma(y3, m00, fma(y2, m01, fma(y, m02, m03)));
        moment[parent + 10] += m40;
        moment[parent + 11] += fma(y, m30, m31);
        moment[parent + 12] += fma(y2, m20, fma(y, m21, m22));
        moment[parent + 13] += fma(y3, m10, fma(y2, m11, fma(y, m12, m13)));
        moment[parent + 14] += fma(y4, m00, fma(y3, m01, fma(y2, m02, fma(y, m03, m04))));
        moment[parent + 15] += m50;
        moment[parent + 16] += fma(y, m40, m41);
        moment[parent + 17] += fma(y2, m30, fma(y, m31, m32));
        moment[parent + 18] += fma(y3, m20, fma(y2, m21, fma(y, m22, m23)));
        moment[parent + 19] += fma(y4, m10, fma(y3, m11, fma(y2, m12, fma(y, m13, m14))));
        moment[parent + 20] += fma(y5, m00, fma(y4, m01, fma(y3, m02, fma(y2, m03, fma(y, m04, m05)))));
    }

    /** Adds the locals that begin at {@code parent}, but the first of them, to those that begin at {@code child}. */
    static void addLocals(double[] local, int parent, int child, double x, double y) {
        double x2 = x * x * (1.0 / 2);
        double x3 = x2 * x * (1.0 / 3);
        double x4 = x3 * x * (1.0 / 4);
        double x5 = x4 * x * (1.0 / 5);
        double y2 = y * y * (1.0 / 2);
        double y3 = y2 * y * (1.0 / 3);
        double y4 = y3 * y * (1.0 / 4);
        double y5 = y4 * y * (1.0 / 5);
        double l10 = local[parent + 1];
        double l20 = local[parent + 3];
        double l30 = local[parent + 6];
        double l40 = local[parent + 10];
        double l50 = local[parent + 15];
        double l60 = local[parent + 21];
        l10 = fma(x5, l60, fma(x4, l50, fma(x3, l40, fma(x2, l30, fma(x, l20, l10)))));
        l20 = fma(x4, l60, fma(x3, l50, fma(x2, l40, fma(x, l30, l20))));
        l30 = fma(x3, l60, fma(x2, l50, fma(x, l40, l30)));
        l40 = fma(x2, l60, fma(x, l50, l40));
        l50 = fma(x, l60, l50);
        double l01 = local[parent + 2];
        double l11 = local[parent + 4];
        double l21 = local[parent + 7];
        double l31 = local[parent + 11];
        double l41 = local[parent + 16];
        double l51 = local[parent + 22];
        l01 = fma(x5, l51, fma(x4, l41, fma(x3, l31, fma(x2, l21, fma(x, l11, l01)))));
        l11 = fma(x4, l51, fma(x3, l41, fma(x2, l31, fma(x, l21, l11))));
        l21 = fma(x3, l51, fma(x2, l41, fma(x, l31, l21)));
        l31 = fma(x2, l51, fma(x, l41, l31));
        l41 = fma(x, l51, l41);
        double l02 = local[parent + 5];
        double l12 = local[parent + 8];
        double l22 = local[parent + 12];
        double l32 = local[parent + 17];
        double l42 = local[parent + 23];
        l02 = fma(x4, l42, fma(x3, l32, fma(x2, l22, fma(x, l12, l02))));
        l12 = fma(x3, l42, fma(x2, l32, fma(x, l22, l12)));
        l22 = fma(x2, l42, fma(x, l32, l22));
        l32 = fma(x, l42, l32);
        double l03 = local[parent + 9];
        double l13 = local[parent + 13];
        double l23 = local[parent + 18];
        double l33 = local[parent + 24];
        l03 = fma(x3, l33, fma(x2, l23, fma(x, l13, l03)));
        l13 = fma(x2, l33, fma(x, l23, l13));
        l23 = fma(x, l33, l23);
        double l04 = local[parent + 14];
        double l14 = local[parent + 19];
        double l24 = local[parent + 25];
        l04 = fma(x2, l24, fma(x, l14, l04));
        l14 = fma(x, l24, l14);
        double l05 = local[parent + 20];
        double l15 = local[parent + 26];
        l05 = fma(x, l15, l05);
        double l06 = local[parent + 27];
        local[child + 1] += fma(y5, l15, fma(y4, l14, fma(y3, l13, fma(y2, l12, fma(y, l11, l10)))));
        local[child + 2] += fma(y5, l06, fma(y4, l05, fma(y3, l04, fma(y2, l03, fma(y, l02, l01)))));
        local[child + 3] += fma(y4, l24, fma(y3, l23, fma(y2, l22, fma(y, l21, l20))));
        local[child + 4] += fma(y4, l15, fma(y3, l14, fma(y2, l13, fma(y, l12, l11))));
        local[child + 5] += fma(y4, l06, fma(y3, l05, fma(y2, l04, fma(y, l03, l02))));
        local[child + 6] += fma(y3, l33, fma(y2, l32, fma(y, l31, l30)));
        local[child + 7] += fma(y3, l24, fma(y2, l23, fma(y, l22, l21)));
        local[child + 8] += fma(y3, l15, fma(y2, l14, fma(y, l13, l12)));
        local[child + 9] += fma(y3, l06, fma(y2, l05, fma(y, l04, l03)));
        local[child + 10] += fma(y2, l42, fma(y, l41, l40));
        local[child + 11] += fma(y2, l33, fma(y, l32, l31));
        local[child + 12] += fma(y2, l24, fma(y, l23, l22));
        local[child + 13] += fma(y2, l15, fma(y, l14, l13));
        local[child + 14] += fma(y2, l06, fma(y, l05, l04));
        local[child + 15] += fma(y, l51, l50);
        local[child + 16] += fma(y, l42, l41);
        local[child + 17] += fma(y, l33, l32);
        local[child + 18] += fma(y, l24, l23);
        local[child + 19] += fma(y, l15, l14);
        local[child + 20] += fma(y, l06, l05);
        local[child + 21] += l60;
        local[child + 22] += l51;
        local[child + 23] += l42;
        local[child + 24] += l33;
        local[child + 25] += l24;
        local[child + 26] += l15;
        local[child + 27] += l06;
    }
}
