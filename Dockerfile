# docker build -t taut . && docker run --rm -u "$(id -u):$(id -g)" -v "$PWD:/here" taut solve maze.txt --svg maze.svg
FROM debian:bookworm AS build
COPY . /taut
WORKDIR /taut
RUN apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
      $(sed -n '/^\[program\]/,/^\[test\]/p; /^\[python\]/,/^\[bench\]/p' cmake/debian-packages.txt | \
        grep -v '^[#[]') file dpkg-dev
RUN cmake --preset package && cmake --build --preset package && \
    cpack --config build/package/CPackConfig.cmake -B /debs

FROM debian:bookworm-slim
COPY --from=build /debs/*.deb /debs/
RUN apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
      $(ls /debs/*.deb | grep -v -e -dev -e -doc) librsvg2-2 fonts-dejavu-core && rm -rf /debs /var/lib/apt/lists/*
WORKDIR /here
ENTRYPOINT ["taut"]
