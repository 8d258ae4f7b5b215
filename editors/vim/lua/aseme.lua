-- Starts `asemec lsp` for the files of ASEME, and for the Python of their projects, in Neovim 0.7 and newer:
--
--   require("aseme").setup()                                      asemec of the .venv above the file, or of the PATH
--   require("aseme").setup({ cmd = { "uv", "run", "asemec", "lsp" } })
--
-- `on_attach`, `capabilities`, `handlers` and whatever else a client takes may stand beside `cmd`.
local M = {}

local clients = {} -- by root; only for Neovim 0.7, which does not look for a running one itself

local function above(name, file)
  local folder = vim.fn.fnamemodify(file, ":p:h")
  local found = vim.fn.findfile(name, vim.fn.escape(folder, " ,;") .. ";")
  if found == "" then
    found = vim.fn.finddir(name, vim.fn.escape(folder, " ,;") .. ";")
  end
  return found ~= "" and vim.fn.fnamemodify(found, ":p") or nil
end

-- The folder of the project: the one with pyproject.toml or .git, else that of the file.
function M.root(file)
  local found = above("pyproject.toml", file)
  if found then
    return vim.fn.fnamemodify(found, ":h")
  end
  found = above(".git", file)
  if found then
    return vim.fn.fnamemodify(found:gsub("/$", ""), ":h")
  end
  return vim.fn.fnamemodify(file, ":p:h")
end

local function command(file)
  local environment = above(".venv", file)
  local own = environment and environment .. "bin/asemec"
  return { own and vim.fn.executable(own) == 1 and own or "asemec", "lsp" }
end

-- Verdicts above the text: asked for anew when the server says so, and after edits.
local function lenses(client)
  client.handlers = vim.tbl_extend("keep", client.handlers or {}, {
    ["workspace/codeLens/refresh"] = function()
      vim.schedule(vim.lsp.codelens.refresh)
      return vim.NIL
    end,
  })
  client.capabilities = vim.tbl_deep_extend(
    "keep",
    client.capabilities or vim.lsp.protocol.make_client_capabilities(),
    { workspace = { codeLens = { refreshSupport = true } } }
  )
  local given = client.on_attach
  client.on_attach = function(...)
    vim.schedule(vim.lsp.codelens.refresh)
    if given then
      given(...)
    end
  end
end

local function follow(buffer)
  vim.api.nvim_create_autocmd({ "BufEnter", "InsertLeave", "TextChanged", "BufWritePost" }, {
    group = vim.api.nvim_create_augroup("aseme_lenses_" .. buffer, { clear = true }),
    buffer = buffer,
    callback = function()
      if #(vim.lsp.get_clients or vim.lsp.get_active_clients)() > 0 then
        vim.lsp.codelens.refresh()
      end
    end,
  })
end

function M.start(buffer, config)
  local file = vim.api.nvim_buf_get_name(buffer)
  if file == "" then
    return
  end
  local client = vim.tbl_extend("keep", { name = "asemec" }, config or {}, {
    cmd = command(file),
    root_dir = M.root(file),
  })
  if vim.fn.executable(client.cmd[1]) == 0 then
    vim.notify_once(
      client.cmd[1] .. ' is not installed; in the clone of aseme-dsl: pip install ".[editor]"',
      vim.log.levels.WARN
    )
    return
  end
  lenses(client)
  follow(buffer)
  if vim.lsp.start then
    vim.lsp.start(client, { bufnr = buffer })
    return
  end
  local id = clients[client.root_dir]
  if not (id and vim.lsp.get_client_by_id(id)) then
    id = vim.lsp.start_client(client)
    clients[client.root_dir] = id
  end
  vim.lsp.buf_attach_client(buffer, id)
end

-- Whether a file is in a project of ASEME: the classes of its activities lead to the model.
function M.in_project(file)
  local found = above("pyproject.toml", file)
  if not found then
    return false
  end
  for _, line in ipairs(vim.fn.readfile(found)) do
    if line:match("^%s*%[tool%.asemec") then
      return true
    end
  end
  return false
end

function M.setup(config)
  vim.api.nvim_create_autocmd("FileType", {
    group = vim.api.nvim_create_augroup("aseme", { clear = true }),
    pattern = { "aseme", "python" },
    callback = function(event)
      if vim.bo[event.buf].filetype == "aseme" or M.in_project(vim.api.nvim_buf_get_name(event.buf)) then
        M.start(event.buf, config)
      end
    end,
  })
end

return M
