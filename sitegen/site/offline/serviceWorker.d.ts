// The scope of these scripts: the compiler's library declares that of a dedicated worker.

/** What the build writes above the scripts: see worker.py. */
declare const BUILD: {
  version: string;
  files: Record<string, string>;
  types: Record<string, string>;
  later: string[];
  pages: Record<string, string[]>;
  isolate: boolean;
};

/** As in runtime/engine.js. */
declare const engine: "jspi" | "asyncify";

interface WorkerGlobalScope {
  readonly clients: Clients;
  readonly registration: ServiceWorkerRegistration;
  skipWaiting(): Promise<void>;
}

interface WorkerGlobalScopeEventMap {
  install: ExtendableEvent;
  activate: ExtendableEvent;
  fetch: FetchEvent;
  message: ExtendableMessageEvent;
}
