package io.github.apsis.server.web;

import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Problem.Code;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.springframework.messaging.Message;
import org.springframework.messaging.simp.stomp.StompCommand;
import org.springframework.messaging.simp.stomp.StompConversionException;
import org.springframework.messaging.simp.stomp.StompHeaderAccessor;
import org.springframework.messaging.support.MessageBuilder;
import org.springframework.stereotype.Component;
import org.springframework.util.MimeTypeUtils;
import org.springframework.web.socket.messaging.StompSubProtocolErrorHandler;
import tools.jackson.databind.json.JsonMapper;

/**
 * The last words to a client whose connection cannot go on: a STOMP ERROR with a problem in it. One text for everything
 * that is not STOMP: Spring's own would name its classes.
 */
@Component
class StompErrors extends StompSubProtocolErrorHandler {
    private final Problem malformed =
            new Problem(Code.MALFORMED_FRAME, "This is not STOMP 1.2. The connection ends here; connect again.");
    private final Problem tooLarge;
    private final JsonMapper json;
    private final Refusals refusals;

    StompErrors(ApsisProperties properties, JsonMapper json, Refusals refusals) {
        this.json = json;
        this.refusals = refusals;
        this.tooLarge = new Problem(
                Code.MESSAGE_TOO_LARGE,
                "A message may have " + properties.limits().messageBytes()
                        + " bytes at most. The connection ends here; send less.");
    }

    @Override
    public Message<byte[]> handleClientMessageProcessingError(
            @Nullable Message<byte[]> clientMessage, Throwable reason) {
        Problem problem = isTooLarge(reason) ? tooLarge : malformed;
        refusals.count(problem.code());
        StompHeaderAccessor error = StompHeaderAccessor.create(StompCommand.ERROR);
        error.setMessage(problem.code().name());
        error.setContentType(MimeTypeUtils.APPLICATION_JSON);
        error.setLeaveMutable(true);
        return MessageBuilder.createMessage(json.writeValueAsBytes(problem), error.getMessageHeaders());
    }

    /** Spring's decoder tells a frame beyond the limit from a malformed one by its text alone. */
    private static boolean isTooLarge(Throwable reason) {
        return reason instanceof StompConversionException
                && String.valueOf(reason.getMessage()).contains("buffer size limit");
    }

    /** The ERROR frame for a message that STOMP does not get to see. */
    String tooLarge() {
        refusals.count(tooLarge.code());
        String body = json.writeValueAsString(tooLarge);
        return "ERROR\nmessage:" + tooLarge.code() + "\ncontent-type:application/json\ncontent-length:"
                + body.getBytes(StandardCharsets.UTF_8).length + "\n\n" + body + "\0";
    }
}
