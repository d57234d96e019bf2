package io.github.apsis.server.web;

/**
 * One message of a stream: encoded once, then framed for each subscriber.
 *
 * @param topic its destination
 * @param headers further STOMP headers, each line ended by a line feed
 * @param json ASCII
 */
record Bulletin(String topic, String headers, String json) {
    static Bulletin plain(String topic, String json) {
        return new Bulletin(topic, "", json);
    }

    /** The STOMP MESSAGE for one subscription. */
    String toStomp(String subscription, String messageId) {
        return "MESSAGE\ndestination:" + topic + "\ncontent-type:application/json\nsubscription:" + subscription
                + "\nmessage-id:" + messageId + "\n" + headers + "content-length:" + json.length() + "\n\n" + json
                + "\0";
    }
}
