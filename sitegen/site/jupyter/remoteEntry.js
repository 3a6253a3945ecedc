// JupyterLab's loader of extensions runs this as a script and asks the container for its module.
{
  let scope = {};
  const { src } = document.currentScript;
  (window._JUPYTERLAB ??= {})["sitegen-ros"] = {
    init(shared) {
      scope = shared;
    },
    async get() {
      const { extension } = await import(new URL("../../../../runtime/jupyter/extension.js", src));
      const plugins = await extension(scope);
      return () => ({ __esModule: true, default: plugins });
    },
  };
}
