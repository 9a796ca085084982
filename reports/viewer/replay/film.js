// SPDX-License-Identifier: BSD-3-Clause
// Saves what the page shows: as a film by the browser's own recorder, or a picture for each frame,
// in one archive (tar), from which ffmpeg makes an mp4.
const fileStem = (scene.name || 'scene').replace(/[^A-Za-z0-9_-]+/g, '_');
const saveAs = (name, blob) => {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};
const filmButton = byId('film'), picturesButton = byId('pictures');
let recorder = null;
const endFilm = () => {
  atEnd = null;
  if (recorder) recorder.stop();
};
// From the start to the end, at the speed that is chosen.
const saveFilm = () => {
  const parts = [];
  recorder = new MediaRecorder(canvas.captureStream(30), {
    mimeType: 'video/webm', videoBitsPerSecond: 8e6,
  });
  recorder.ondataavailable = (event) => parts.push(event.data);
  recorder.onstop = () => {
    recorder = null;
    filmButton.textContent = 'Save film';
    const film = new Blob(parts, { type: 'video/webm' });
    report.film = film.size;
    saveAs(`${fileStem}.webm`, film);
  };
  filmButton.textContent = 'Stop';
  go(0);
  playing = true;
  showPlaying();
  atEnd = endFilm;
  recorder.start();
};
filmButton.addEventListener('click', () => (recorder ? endFilm() : saveFilm()));
filmButton.hidden = !window.MediaRecorder || !canvas.captureStream;

// A member of an archive (POSIX.1-1988, ustar): a header of 512 bytes, and whole blocks of bytes.
const tarMember = async (name, blob) => {
  const header = new Uint8Array(512), octal = (n, size) => n.toString(8).padStart(size - 1, '0');
  const put = (at, text) => header.set(new TextEncoder().encode(text), at);
  put(0, name);
  put(100, '0000644');
  put(108, '0000000');
  put(116, '0000000');
  put(124, octal(blob.size, 12));
  put(136, octal(0, 12));
  put(148, '        ');
  put(156, '0');
  put(257, 'ustar');
  put(263, '00');
  put(148, octal(header.reduce((sum, byte) => sum + byte, 0), 7));
  return [header, await blob.arrayBuffer(), new Uint8Array((512 - (blob.size % 512)) % 512)];
};
const savePictures = async () => {
  picturesButton.disabled = true;
  playing = false;
  showPlaying();
  const parts = [];
  for (let k = 0; k <= last; ++k) {
    go(times[k]);
    show();
    const picture = await new Promise((done) => canvas.toBlob(done, 'image/png'));
    parts.push(...(await tarMember(`${fileStem}/${String(k + 1).padStart(4, '0')}.png`, picture)));
    picturesButton.textContent = `${k + 1} of ${last + 1}`;
  }
  parts.push(new Uint8Array(1024));
  const archive = new Blob(parts, { type: 'application/x-tar' });
  report.pictures = archive.size;
  saveAs(`${fileStem}.tar`, archive);
  picturesButton.disabled = false;
  picturesButton.textContent = 'Save pictures';
};
picturesButton.addEventListener('click', savePictures);
