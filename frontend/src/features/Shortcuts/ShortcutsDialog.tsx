import { useEffect, useRef } from 'react';
import { Button } from '../../ui/Button';
import { Icon } from '../../ui/Icon';
import styles from './ShortcutsDialog.module.css';
import { POINTER, SHORTCUTS } from './shortcuts';

type ShortcutsDialogProps = { isOpen: boolean; onClose: () => void };

const GROUPS = ['Add', 'Select', 'Send ships', 'Look'] as const;

/** What keys and pointer do, and what the page is made of. */
export function ShortcutsDialog({ isOpen, onClose }: ShortcutsDialogProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (isOpen) dialog.current?.showModal();
    else dialog.current?.close();
  }, [isOpen]);

  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: the dialog closes with Escape by itself; the click is on its veil.
    <dialog
      ref={dialog}
      className={styles.dialog}
      aria-labelledby="shortcuts-title"
      onClose={onClose}
      onClick={(event) => event.target === event.currentTarget && onClose()}
    >
      <div className={styles.content}>
        <div className={styles.head}>
          <h2 id="shortcuts-title" className={styles.title}>
            Keyboard and pointer
          </h2>
          <Button aria-label="Close" onClick={onClose}>
            <Icon name="close" />
          </Button>
        </div>
        <div className={styles.groups}>
          {GROUPS.map((group) => (
            <Group
              key={group}
              title={group}
              rows={SHORTCUTS.filter((shortcut) => shortcut.group === group && shortcut.text !== '')}
            />
          ))}
          <Group title="On the stage" rows={POINTER} />
        </div>
        <p className={styles.about}>
          Apsis. The stage is drawn with p5, an unmodified module under the LGPL 2.1; the typeface is B612 under the
          Open Font License.
        </p>
      </div>
    </dialog>
  );
}

type GroupProps = { title: string; rows: readonly { readonly shown: string; readonly text: string }[] };

function Group({ title, rows }: GroupProps) {
  return (
    <section className={styles.group}>
      <h3 className={styles.groupTitle}>{title}</h3>
      <dl>
        {rows.map(({ shown, text }) => (
          <div key={shown} className={styles.row}>
            <dt className={styles.keys}>{shown}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}
