package io.github.apsis.server.web;

import org.springframework.boot.tomcat.servlet.TomcatServletWebServerFactory;
import org.springframework.boot.web.server.WebServerFactoryCustomizer;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Sockets for a stream of which only the newest frame counts. */
@Configuration
class TomcatConfig {
    /** Frames that the kernel holds are frames that grow old: left alone it keeps megabytes for one slow client. */
    private static final String SEND_BUFFER_BYTES = "131072";

    @Bean
    WebServerFactoryCustomizer<TomcatServletWebServerFactory> smallSendBuffers() {
        return tomcat -> tomcat.addConnectorCustomizers(
                connector -> connector.setProperty("socket.txBufSize", SEND_BUFFER_BYTES));
    }
}
