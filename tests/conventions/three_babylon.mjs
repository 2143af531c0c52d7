// Prints golden rows from three and @babylonjs/core: name,source,unit,x,y,z,values...   (run by check.py)
import { readFileSync } from 'node:fs';
import { SphericalHarmonics3, Vector3 } from 'three';
import { SphericalHarmonics, SphericalPolynomial } from '@babylonjs/core/Maths/sphericalPolynomial.js';
import { Vector3 as BabylonVector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Color3 } from '@babylonjs/core/Maths/math.color.js';

const version = (name) => JSON.parse(readFileSync(new URL(`./node_modules/${name}/package.json`, import.meta.url))).version;
const three = `three ${version('three')}`, babylon = `@babylonjs/core ${version('@babylonjs/core')}`;
const row = (name, source, kind, d, values) => console.log([name, source, kind, ...d, ...values].join(','));
const names = ['l00', 'l1_1', 'l10', 'l11', 'l2_2', 'l2_1', 'l20', 'l21', 'l22'];

for (const d of [[2 / 7, 3 / 7, 6 / 7], [-6 / 7, 2 / 7, -3 / 7]]) {
    const basis = [];
    SphericalHarmonics3.getBasisAt(new Vector3(...d), basis);
    row('three', `${three} SphericalHarmonics3.getBasisAt`, 'coefficients', d, basis);

    const light = new SphericalHarmonics3(), n = new Vector3(6 / 7, 3 / 7, 2 / 7), e = new Vector3();
    for (let i = 0; i < 9; i++) light.coefficients[i].set(basis[i], basis[i], basis[i]);
    light.getIrradianceAt(n, e);
    row('three', `${three} SphericalHarmonics3.getIrradianceAt(6/7 3/7 2/7)`, 'irradiance', d, [e.x]);

    const impulse = () => {
        const h = new SphericalHarmonics();
        h.addLight(new BabylonVector3(...d), new Color3(1, 1, 1), 1);
        return h;
    };
    row('babylon', `${babylon} SphericalHarmonics.addLight`, 'coefficients', d, names.map((k) => impulse()[k].x));
    const p = SphericalPolynomial.FromHarmonics(impulse());
    row('babylon-polynomial', `${babylon} SphericalPolynomial.FromHarmonics`, 'coefficients', d,
        ['x', 'y', 'z', 'xx', 'yy', 'zz', 'yz', 'zx', 'xy'].map((k) => p[k].x));
    const h = impulse();
    h.convertIncidentRadianceToIrradiance();
    row('gltf', `${babylon} convertIncidentRadianceToIrradiance: the form its EXT_lights_image_based loader reads`, 'coefficients', d,
        names.map((k) => h[k].x));
}
