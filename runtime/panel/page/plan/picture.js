// Makes a bitmap of an SVG or PNG, once, so that it need not be drawn again with each frame.

const kMost = 4096;  // pixels of a side

/// The size of the bitmap: an SVG as large as it may be, since it is zoomed; a PNG as it is, if it is not too large.
export const bitmapSize = (width, height, isVector) => {
  const most = kMost / Math.max(width, height);
  const factor = isVector ? most : Math.min(1, most);
  return [width, height].map((side) => Math.max(1, Math.round(side * factor)));
};

/// The canvas with a picture; fails with a text if the browser cannot show it. Scripts in it do not run.
export const openPicture = async (blob) => {
  const url = URL.createObjectURL(blob);
  try {
    const image = new Image();
    image.src = url;
    await image.decode().catch(() => { throw new Error("the browser cannot show it"); });
    if (image.naturalWidth === 0 || image.naturalHeight === 0) throw new Error("it has no width and height");
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = bitmapSize(image.naturalWidth, image.naturalHeight, blob.type.startsWith("image/svg"));
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas;
  } finally {
    URL.revokeObjectURL(url);
  }
};
