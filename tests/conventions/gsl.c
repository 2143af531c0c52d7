/* Prints golden rows from GSL: expansion of a unit impulse in its SPHARM-normalised Legendre functions times cos, sin. */
#include <gsl/gsl_sf_legendre.h>
#include <gsl/gsl_version.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    static const double d[2][3] = { { 2.0 / 7, 3.0 / 7, 6.0 / 7 }, { -6.0 / 7, 2.0 / 7, -3.0 / 7 } };
    enum { BANDS = 5 };
    double p[64];
    int k, l, m, part;

    for (k = 0; k < 2; k++) {
        const double phi = atan2(d[k][1], d[k][0]);
        gsl_sf_legendre_array(GSL_SF_LEGENDRE_SPHARM, BANDS - 1, d[k][2], p);
        printf("gsl,GSL %s gsl_sf_legendre_array(GSL_SF_LEGENDRE_SPHARM),coefficients,%.17g,%.17g,%.17g", GSL_VERSION,
               d[k][0], d[k][1], d[k][2]);
        for (part = 0; part < 2; part++)
            for (l = 0; l < BANDS; l++)
                for (m = 0; m <= l; m++)
                    printf(",%.17g", (m ? 2 : 1) * p[gsl_sf_legendre_array_index((size_t)l, (size_t)m)] *
                                     (part ? sin(m * phi) : cos(m * phi)));
        printf("\n");
    }
    return 0;
}
