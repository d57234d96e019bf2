import type { ButtonHTMLAttributes } from 'react';
import styles from './Button.module.css';

type ButtonProps = ButtonHTMLAttributes<HTMLButtonElement>;

/** A button as everywhere on the page. A toggle says so with aria-pressed. */
export function Button(props: ButtonProps) {
  return <button type="button" {...props} className={`${styles.button} ${props.className ?? ''}`} />;
}
