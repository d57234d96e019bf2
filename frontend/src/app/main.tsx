import '../ui/tokens.css';
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { App } from './App';
import { RoomClient } from './RoomClient';

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <App client={new RoomClient()} />
  </StrictMode>,
);
