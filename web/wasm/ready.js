// What web/page.h asks of the glue.
self.tautReady = async (bytes) => {
  const taut = await tautModule({wasmBinary: bytes});
  return (text) => {
    const size = taut.lengthBytesUTF8(text) + 1;
    const asked = taut._malloc(size);
    if (!asked) return '{"error":"out of memory"}';
    taut.stringToUTF8(text, asked, size);
    const answer = taut.UTF8ToString(taut._taut_answer(asked));
    taut._free(asked);
    return answer;
  };
};
