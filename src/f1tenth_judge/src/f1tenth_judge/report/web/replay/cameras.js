// What the planners saw, beside the map.

import { element } from "../base/elements.js";
import { indexAfter } from "../data/geometry.js";

export class Cameras {
  // `pictures` are {topic, time, images}.
  constructor(pictures) {
    this.cameras = pictures.map((each) => ({ ...each, picture: element("img", { alt: `seen on ${each.topic}` }), shown: -1 }));
    this.root = element("div.cameras", { hidden: !pictures.length },
      ...this.cameras.map(({ topic, picture }) => element("figure", {}, picture, element("figcaption", {}, topic))));
  }

  draw(time) {
    for (const camera of this.cameras) {
      const index = indexAfter(camera.time, time) - 1;
      camera.picture.style.visibility = index < 0 ? "hidden" : "visible";
      if (index >= 0 && index !== camera.shown) camera.picture.src = `data:image/jpeg;base64,${camera.images[index]}`;
      camera.shown = index;
    }
  }
}
