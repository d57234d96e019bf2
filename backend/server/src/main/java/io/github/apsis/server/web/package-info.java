/**
 * Rooms on the wire: STOMP over WebSocket and SockJS, the page, health and metrics. The treaty is {@code
 * docs/protocol}.
 */
@NullMarked
package io.github.apsis.server.web;

import org.jspecify.annotations.NullMarked;
