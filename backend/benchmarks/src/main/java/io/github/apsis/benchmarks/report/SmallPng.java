package io.github.apsis.benchmarks.report;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/**
 * Writes a drawing as a PNG of its 64 commonest colours, others by the nearest of them. A chart has few colours but many
 * blends at the edges of letters: half of the size in all colours, and no difference to the eye. (The palette that Java
 * brings has none of our colours, and dithers.)
 */
final class SmallPng {
    private static final int COLORS = 64;

    private SmallPng() {}

    static void write(BufferedImage drawing, Path file) throws IOException {
        int[] palette = commonest(drawing);
        var model = new IndexColorModel(8, palette.length, palette, 0, false, -1, DataBuffer.TYPE_BYTE);
        var indexed =
                new BufferedImage(drawing.getWidth(), drawing.getHeight(), BufferedImage.TYPE_BYTE_INDEXED, model);
        Map<Integer, Integer> indices = new HashMap<>();
        for (int y = 0; y < drawing.getHeight(); y++) {
            for (int x = 0; x < drawing.getWidth(); x++) {
                int index = indices.computeIfAbsent(rgb(drawing, x, y), color -> nearest(palette, color));
                indexed.getRaster().setSample(x, y, 0, index);
            }
        }
        compress(indexed, file);
    }

    private static void compress(BufferedImage indexed, Path file) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam smallest = writer.getDefaultWriteParam();
        smallest.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        smallest.setCompressionQuality(0); // of the effort, not of the picture: PNG loses nothing
        Files.deleteIfExists(file); // a shorter file would keep the tail of a longer one
        try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
            writer.setOutput(out);
            writer.write(null, new IIOImage(indexed, null, null), smallest);
        } finally {
            writer.dispose();
        }
    }

    private static int rgb(BufferedImage drawing, int x, int y) {
        return drawing.getRGB(x, y) & 0xffffff;
    }

    private static int[] commonest(BufferedImage drawing) {
        Map<Integer, Integer> counts = new HashMap<>();
        for (int y = 0; y < drawing.getHeight(); y++) {
            for (int x = 0; x < drawing.getWidth(); x++) {
                counts.merge(rgb(drawing, x, y), 1, Integer::sum);
            }
        }
        List<Integer> byCount = counts.entrySet().stream()
                .sorted(Map.Entry.<Integer, Integer>comparingByValue()
                        .reversed()
                        .thenComparing(Map.Entry.comparingByKey())) // the same drawing gives the same file
                .limit(COLORS)
                .map(Map.Entry::getKey)
                .toList();
        return byCount.stream().mapToInt(Integer::intValue).toArray();
    }

    private static int nearest(int[] palette, int color) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < palette.length; i++) {
            int distance = square(palette[i] >> 16, color >> 16) // red
                    + square(palette[i] >> 8, color >> 8)
                    + square(palette[i], color);
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    private static int square(int a, int b) {
        int difference = (a & 0xff) - (b & 0xff);
        return difference * difference;
    }
}
