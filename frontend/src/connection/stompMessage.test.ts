import { describe, expect, it } from 'vitest';
import { splitMessage } from './stompMessage';

const wire = 'MESSAGE\ndestination:/topic/bodies\ntick:7\nsubscription:sub-0\n\n[{"id":1}]\0';

describe('splitMessage', () => {
  it('takes_the_headers_and_the_body_of_its_destination', () => {
    const message = splitMessage(wire, '/topic/bodies');

    expect(message?.headers).toMatchObject({ tick: '7' });
    expect(message?.body).toBe('[{"id":1}]');
  });

  it('reads_binary_messages_too', () => {
    // The encoder of the test environment has an ArrayBuffer of its own kind.
    const bytes = new TextEncoder().encode(wire);
    const buffer = new ArrayBuffer(bytes.length);
    new Uint8Array(buffer).set(bytes);
    expect(splitMessage(buffer, '/topic/bodies')?.body).toBe('[{"id":1}]');
  });

  it.each([
    ['another_destination', wire.replace('/topic/bodies', '/topic/diagnostics')],
    ['a_heart_beat', '\n'],
    ['another_command', 'CONNECTED\nversion:1.2\n\n\0'],
    ['half_a_frame', wire.slice(0, 60)],
  ])('leaves_%s_to_the_parser', (_name, data) => {
    expect(splitMessage(data, '/topic/bodies')).toBeNull();
  });
});
