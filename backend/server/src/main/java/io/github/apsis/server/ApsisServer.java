package io.github.apsis.server;

import org.springframework.boot.SpringApplication;
import org.springframework.boot.autoconfigure.SpringBootApplication;
import org.springframework.boot.context.properties.ConfigurationPropertiesScan;

/** Starts the server. */
@SpringBootApplication
@ConfigurationPropertiesScan
public class ApsisServer {
    public static void main(String[] args) {
        SpringApplication.run(ApsisServer.class, args);
    }
}
