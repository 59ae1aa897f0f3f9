// Lets modules that import three.js run without a browser: finds three.js where the build finds it, and has what the page asks its style sheet.
import {register} from "node:module";
import {pathToFileURL} from "node:url";

const kThree = pathToFileURL(process.env.SYMPLANT_THREE ?? "/usr/share/javascript/three").href;
const kFiles = {"three.module.js": "/three.module.js", "GLTFLoader.js": "/examples/jsm/loaders/GLTFLoader.js", "OrbitControls.js": "/examples/jsm/controls/OrbitControls.js"};

register("data:text/javascript," + encodeURIComponent(`
  const files = ${JSON.stringify(kFiles)};
  export const resolve = (specifier, context, next) => {
    const file = files[specifier.split("/").pop()];
    return file ? {url: ${JSON.stringify(kThree)} + file, format: "module", shortCircuit: true} : next(specifier, context);
  };`));

globalThis.matchMedia = () => ({matches: false, addEventListener() {}});
globalThis.document = {documentElement: null};
globalThis.getComputedStyle = () => ({getPropertyValue: () => "#336699"});
