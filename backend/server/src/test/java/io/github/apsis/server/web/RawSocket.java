package io.github.apsis.server.web;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** A WebSocket by hand, for what no well-behaved client does. */
final class RawSocket implements AutoCloseable {
    private static final int CLOSE = 8;
    private static final int PATIENCE_MILLIS = 15_000;

    private final Socket socket = new Socket();
    private final DataInputStream in;
    private final OutputStream out;
    private final List<String> responseHead = new ArrayList<>();

    /** What came: text, or the status of a close. */
    record Received(String text, int closeStatus) {
        boolean isClose() {
            return closeStatus > 0;
        }
    }

    /** Asks for the upgrade, with these further headers. */
    RawSocket(int port, String path, String... headers) throws IOException {
        socket.setReceiveBufferSize(32 * 1024);
        socket.setSoTimeout(PATIENCE_MILLIS);
        socket.connect(new InetSocketAddress("localhost", port));
        in = new DataInputStream(new java.io.BufferedInputStream(socket.getInputStream()));
        out = socket.getOutputStream();
        String request = "GET " + path + " HTTP/1.1\r\nHost: localhost:" + port
                + "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                + "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                + String.join(
                        "",
                        List.of(headers).stream().map(header -> header + "\r\n").toList()) + "\r\n";
        out.write(request.getBytes(StandardCharsets.US_ASCII));
        readResponseHead();
    }

    private void readResponseHead() throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        while (true) {
            int b = in.read();
            if (b == '\n') {
                String text = line.toString(StandardCharsets.US_ASCII).strip();
                line.reset();
                if (text.isEmpty()) {
                    return;
                }
                responseHead.add(text);
            } else if (b < 0) {
                throw new IOException("closed before the end of the response");
            } else {
                line.write(b);
            }
        }
    }

    int status() {
        return Integer.parseInt(responseHead.get(0).split(" ")[1]);
    }

    List<String> responseHead() {
        return responseHead;
    }

    /** A text message in one frame, masked with zeros. */
    void send(String text) throws IOException {
        byte[] payload = text.getBytes(StandardCharsets.UTF_8);
        ByteArrayOutputStream frame = new ByteArrayOutputStream();
        frame.write(0x81);
        if (payload.length < 126) {
            frame.write(0x80 | payload.length);
        } else {
            frame.write(0x80 | 127);
            for (int shift = 56; shift >= 0; shift -= 8) {
                frame.write((int) ((long) payload.length >>> shift) & 0xFF);
            }
        }
        frame.write(new byte[4], 0, 4);
        frame.writeBytes(payload);
        out.write(frame.toByteArray());
    }

    void connectStomp() throws IOException {
        send("CONNECT\naccept-version:1.2\nhost:localhost\n\n\0");
    }

    /** The next message, put together from its fragments; heart-beats of WebSocket itself are left out. */
    Received receive() throws IOException {
        StringBuilder text = new StringBuilder();
        while (true) {
            int head = in.readUnsignedByte();
            long length = in.readUnsignedByte() & 0x7F;
            if (length == 126) {
                length = in.readUnsignedShort();
            } else if (length == 127) {
                length = in.readLong();
            }
            byte[] payload = in.readNBytes((int) length);
            int opcode = head & 0x0F;
            if (opcode == CLOSE) {
                return new Received("", (payload[0] & 0xFF) << 8 | payload[1] & 0xFF);
            }
            if (opcode <= 2) {
                text.append(new String(payload, StandardCharsets.UTF_8));
                if ((head & 0x80) != 0) {
                    return new Received(text.toString(), 0);
                }
            }
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
