# The workspace on Debian 13.
#   docker build --target build -t f1tenth .        everything installed and built: docker run --rm f1tenth make race
#   docker build --target test -t f1tenth-test .    with what tests need:            docker run --rm f1tenth-test make test
FROM debian:trixie-slim AS system
RUN apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
    ca-certificates git make
WORKDIR /workspace

FROM system AS build
COPY setup setup
COPY tools/setup tools/setup
RUN tools/setup
COPY . .
RUN make build UNITY=ON
CMD ["make", "race"]

FROM build AS test
RUN tools/setup --tests
CMD ["make", "test"]
