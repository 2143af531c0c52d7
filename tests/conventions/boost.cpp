// Prints golden rows from Boost: conj of spherical_harmonic(l, m, polar, azimuth), a unit impulse's coefficients.
#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <boost/version.hpp>
#include <cstdio>

int main()
{
    const double d[2][3] = { { 2.0 / 7, 3.0 / 7, 6.0 / 7 }, { -6.0 / 7, 2.0 / 7, -3.0 / 7 } };
    for (const auto &u : d) {
        std::printf("boost,Boost %d.%d spherical_harmonic,coefficients,%.17g,%.17g,%.17g", BOOST_VERSION / 100000,
                    BOOST_VERSION / 100 % 1000, u[0], u[1], u[2]);
        for (unsigned l = 0; l < 5; l++)
            for (int m = -(int)l; m <= (int)l; m++) {
                const std::complex<double> y = boost::math::spherical_harmonic(l, m, std::acos(u[2]), std::atan2(u[1], u[0]));
                std::printf(",%.17g,%.17g", y.real(), -y.imag());
            }
        std::printf("\n");
    }
}
