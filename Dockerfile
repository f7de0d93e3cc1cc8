# The base image is a build argument, so that an installation pins it to a digest it has checked:
#   docker build --build-arg PYTHON_IMAGE=python:3.12-slim-bookworm@sha256:… .
ARG PYTHON_IMAGE=python:3.12-slim-bookworm

# What the pages load in the browser, from npm. Node comes as a Python wheel, under the same hash locks.
FROM ${PYTHON_IMAGE} AS vendor
WORKDIR /build
COPY requirements-node.lock ./
RUN python -m venv --without-pip /opt/node \
    && python -m pip --python /opt/node/bin/python install --no-cache-dir --no-compile --disable-pip-version-check \
       --require-hashes --only-binary :all: -r requirements-node.lock
COPY package.json package-lock.json .npmrc ./
COPY tools/vendor.py tools/vendor.py
RUN /opt/node/bin/python tools/vendor.py --omit-dev

# What the service imports: without the packages' own tests, type stubs and headers, the symbol tables of their
# libraries, fonts that nothing is set in, the locale data of languages that it does not speak, and the sources of what
# is compiled (a traceback still names file and line). Libraries that were patched for their wheel (numpy, psycopg)
# stay as they are: strip leaves them unusable.
FROM ${PYTHON_IMAGE} AS packages
# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install --yes --no-install-recommends binutils \
    && rm -rf /var/lib/apt/lists/*
WORKDIR /build
COPY requirements.lock requirements-telemetry.lock ./
# With traces: docker build --build-arg LOCK=requirements-telemetry.lock .
ARG LOCK
RUN python -m venv --without-pip /opt/framewise \
    && python -m pip --python /opt/framewise/bin/python install --no-cache-dir --no-compile --disable-pip-version-check \
       --require-hashes --only-binary :all: -r "${LOCK:-requirements.lock}" \
    && find /opt/framewise -path '*/babel/locale-data/*.dat' ! -name root.dat ! -name en.dat ! -name es.dat \
       ! -name en_001.dat ! -name en_GB.dat ! -name fr.dat ! -name pt.dat ! -name pt_PT.dat ! -name ro.dat ! -name uk.dat -delete \
    && find /opt/framewise -path '*/pymupdf_fonts/*.py' ! -name __init__.py ! -name 'FiraGO_*' -delete \
    && find /opt/framewise -type d -name tests -path '*/site-packages/*' -prune -exec rm -r {} + \
    && find /opt/framewise -type f \( -name '*.pyi' -o -name '*.pyx' -o -name '*.pxd' -o -name '*.h' -o -name '*.a' \
       -o -path '*.dist-info/sboms/*' \) -delete \
    && find /opt/framewise -type f -name '*.so*' ! -path '*.libs/*' ! -path '*/numpy/*' ! -path '*/psycopg_binary/*' \
       -exec strip --strip-unneeded {} + \
    && /opt/framewise/bin/python -m compileall -q -b /opt/framewise/lib \
    && find /opt/framewise/lib -name '*.py' -delete

# The system below: the base without what installs packages and without what only development needs of Python.
FROM ${PYTHON_IMAGE} AS system
# hadolint ignore=DL3003
RUN useradd --uid 10001 --user-group --no-create-home --shell /usr/sbin/nologin framewise \
    && dpkg --purge --force-all apt libapt-pkg6.0 gpgv perl-base util-linux mount login passwd e2fsprogs logsave \
    && rm -r /usr/lib/*/gconv \
    && cd /usr/local \
    && rm -rf include lib/pkgconfig bin/2to3* bin/idle* bin/pip* bin/pydoc* bin/python*-config bin/python*-gdb.py \
    && cd lib/python3.* \
    && rm -rf config-* ensurepip idlelib lib2to3 pydoc_data site-packages/* tkinter turtledemo turtle.py

# One layer: what an image removes from its base would still travel with it.
FROM scratch AS service
# hadolint ignore=DL3067
COPY --from=system / /
COPY --from=packages /opt/framewise /opt/framewise
WORKDIR /app
COPY LICENSE README.md ./
COPY kinematics kinematics
COPY exercises exercises
COPY courses courses
COPY service service
COPY static static
COPY --from=vendor /build/static/vendor static/vendor
RUN /opt/framewise/bin/python -m compileall -q kinematics exercises courses service
ENV PATH=/opt/framewise/bin:/usr/local/bin:/usr/bin:/bin \
    LANG=C.UTF-8 \
    PYTHONUNBUFFERED=1 \
    PYTHONDONTWRITEBYTECODE=1 \
    FRAMEWISE_HOST=0.0.0.0 \
    FRAMEWISE_PORT=8000
RUN install --directory --owner=10001 --group=10001 --mode=700 /data
ENV FRAMEWISE_DATA_FOLDER=/data
VOLUME /data
USER 10001:10001
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=5s --start-period=10s --retries=3 CMD ["python", "-m", "service.probe"]
CMD ["python", "-m", "service"]
