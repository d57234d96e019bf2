package io.github.apsis.benchmarks.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * A log-log chart as all of the report's are: ours as lines with round marks, the peer's as marks alone or dashed, in the
 * colours of Okabe and Ito (2008), which people with any kind of colour vision tell apart; the legend beside the data.
 */
public final class Chart {
    public static final int WIDTH = 900;
    public static final int HEIGHT = 600;
    public static final Color BLACK = new Color(0x22, 0x22, 0x22);
    public static final Color BLUE = new Color(0x00, 0x72, 0xB2);
    public static final Color ORANGE = new Color(0xE6, 0x9F, 0x00);
    public static final Color GREEN = new Color(0x00, 0x9E, 0x73);
    public static final Color VERMILION = new Color(0xD5, 0x5E, 0x00);
    public static final Color PURPLE = new Color(0xCC, 0x79, 0xA7);
    public static final Color SKY = new Color(0x56, 0xB4, 0xE9);
    public static final Color GREY = new Color(0x77, 0x77, 0x77);

    private static final double FLOOR = 1e-17; // a logarithm has no place for 0
    private static final Color GRID = new Color(0xE4, 0xE4, 0xE4);
    private final XYChart chart;

    public Chart(String title, String x, String y) {
        System.setProperty("java.awt.headless", "true");
        chart = new XYChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title(title)
                .xAxisTitle(x)
                .yAxisTitle(y)
                .build();
        var style = chart.getStyler();
        style.setXAxisLogarithmic(true);
        style.setYAxisLogarithmic(true);
        style.setLegendPosition(Styler.LegendPosition.OutsideE);
        style.setLegendBorderColor(Color.WHITE);
        style.setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        style.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
        style.setAxisTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        style.setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        style.setChartBackgroundColor(Color.WHITE);
        style.setPlotGridLinesColor(GRID);
        style.setPlotGridLinesStroke(new BasicStroke(1));
        style.setPlotBorderVisible(false);
        style.setChartTitleBoxVisible(false);
        style.setXAxisDecimalPattern("0.###");
        style.setYAxisDecimalPattern("0E0");
        style.setMarkerSize(8);
        style.setAntiAlias(true);
    }

    /** A line with marks; nothing when there are no points. */
    public void line(String name, List<double[]> points, Color color) {
        add(name, points, color, SeriesMarkers.CIRCLE, new BasicStroke(2.2f));
    }

    /** A line without marks. */
    public void curve(String name, List<double[]> points, Color color) {
        add(name, points, color, SeriesMarkers.NONE, new BasicStroke(2.2f));
    }

    /** A dashed line with marks of its own, for what is not ours. */
    public void peer(String name, List<double[]> points, Color color, Marker marker) {
        add(
                name,
                points,
                color,
                marker,
                new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {5, 4}, 0));
    }

    private void add(String name, List<double[]> points, Color color, Marker marker, BasicStroke stroke) {
        List<double[]> drawn = points.stream()
                .filter(point -> point[0] > 0 && Double.isFinite(point[0]) && Double.isFinite(point[1]))
                .toList();
        if (drawn.isEmpty()) {
            return;
        }
        XYSeries series = chart.addSeries(
                name,
                drawn.stream().mapToDouble(point -> point[0]).toArray(),
                drawn.stream().mapToDouble(point -> Math.max(FLOOR, point[1])).toArray());
        series.setLineColor(color);
        series.setMarkerColor(color);
        series.setMarker(marker);
        series.setLineStyle(stroke);
    }

    public boolean isEmpty() {
        return chart.getSeriesMap().isEmpty();
    }

    public void write(Path file) throws IOException {
        SmallPng.write(BitmapEncoder.getBufferedImage(chart), file);
    }
}
