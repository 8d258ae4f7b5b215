"""OpenTelemetry: the measures of a process, exported by OTLP over HTTP; needs the extra `otel`.

Where they go, and how often, is what the usual environment variables say (`OTEL_EXPORTER_OTLP_ENDPOINT`,
`OTEL_METRIC_EXPORT_INTERVAL`, `OTEL_RESOURCE_ATTRIBUTES`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING

from aseme_dsl.project.operating.measures import FAMILIES, Family, Measure

if TYPE_CHECKING:
    from opentelemetry.metrics import CallbackOptions, Observation
    from opentelemetry.sdk.metrics.export import MetricReader

END_MS = 1000
"""How long, in ms, the last export may take."""


class ExportError(Exception):
    """Metrics cannot be exported; the text says why."""


@contextmanager
def exporting(
    measure: Callable[[], Iterable[Measure]], system: str, reader: MetricReader | None = None
) -> Iterator[None]:
    """Inside, what `measure` gives is exported now and then; by the `reader`, if there is one.

    Raises:
        ExportError: the extra is not installed.
    """
    try:
        from opentelemetry.exporter.otlp.proto.http.metric_exporter import OTLPMetricExporter
        from opentelemetry.sdk.metrics import MeterProvider
        from opentelemetry.sdk.metrics.export import PeriodicExportingMetricReader
        from opentelemetry.sdk.resources import Resource
    except ImportError as missing:
        raise ExportError(f"{missing}: pip install 'aseme-dsl[otel]'") from missing
    resource = Resource.create({"service.name": "asemec", "asemec.system": system})
    reader = reader or PeriodicExportingMetricReader(OTLPMetricExporter())
    provider = MeterProvider([reader], resource, shutdown_on_exit=False)
    meter = provider.get_meter("aseme_dsl")
    for family in FAMILIES:
        observe = _observing(family, measure)
        if family.is_counter:
            meter.create_observable_counter(family.name, [observe], description=family.help)
        else:
            meter.create_observable_gauge(family.name, [observe], description=family.help)
    try:
        yield
    finally:
        with suppress(Exception):  # of the library, when nothing listens
            provider.shutdown(END_MS)


def _observing(
    family: Family, measure: Callable[[], Iterable[Measure]]
) -> Callable[[CallbackOptions], Iterable[Observation]]:
    from opentelemetry.metrics import Observation

    def observe(options: CallbackOptions) -> Iterable[Observation]:
        return [Observation(x.value, dict(x.labels)) for x in measure() if x.name == family.name]

    return observe


__all__ = ["ExportError", "exporting"]
