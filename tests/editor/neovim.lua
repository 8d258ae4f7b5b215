-- Walks through a project in Neovim as a person would; what was seen goes into $NVIM_RESULT as JSON.
local seen = {}
local MOST = 60000 -- milliseconds for anything to happen

local function wait(what, condition)
  if not vim.wait(MOST, condition, 20) then
    error("nothing came of: " .. what)
  end
end

local function find(text)
  vim.fn.cursor(1, 1)
  assert(vim.fn.search(text, "c") > 0, text)
end

local function diagnostics()
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(0)) do
    table.insert(found, (each.lnum + 1) .. ": " .. each.message:gsub("\n.*", ""))
  end
  table.sort(found)
  return found
end

local function ask(method, params)
  local answers = vim.lsp.buf_request_sync(0, method, params or vim.lsp.util.make_position_params(0, "utf-16"), MOST)
  for _, answer in pairs(answers or {}) do
    assert(not answer.err, vim.inspect(answer.err))
    return answer.result
  end
end

local function lines()
  return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), "\n") .. "\n"
end

local function walk()
  vim.cmd("edit team.aseme")
  seen.filetype = vim.bo.filetype
  wait("diagnostics", function() return #vim.diagnostic.get(0) > 0 end)
  seen.mistakes = diagnostics()

  find("Kik\\>")
  vim.cmd("normal! ciwKick")
  wait("the mended text", function() return #vim.diagnostic.get(0) == 0 end)

  find("enter Look")
  vim.cmd("normal! O    enter ")
  local place = vim.lsp.util.make_position_params(0, "utf-16")
  place.position.character = place.position.character + 1 -- behind the blank, where one types
  local offered = ask("textDocument/completion", place)
  seen.completion = {}
  for _, item in ipairs(offered.items or offered) do
    table.insert(seen.completion, item.label)
  end
  vim.cmd("normal! dd")

  find("ready && near") -- a condition pasted from KSE, and what is offered for it, as a person takes it
  vim.cmd("normal! ci[ready && near && !(vision.State.Ball==NULL)")
  wait("the pasted condition", function() return table.concat(diagnostics()):find("of KSE", 1, true) ~= nil end)
  seen.pasted = diagnostics()
  find("State.Ball==")
  vim.ui.select = function(items, _, take)
    seen.offered = items[1].action and items[1].action.title or items[1][2].title
    take(items[1], 1)
  end
  vim.lsp.buf.code_action()
  wait("the translation", function() return lines():find("has(", 1, true) ~= nil end)
  wait("the translated text", function() return #vim.diagnostic.get(0) == 0 end)
  seen.translated = vim.trim(vim.fn.getline("."))
  find("ready && near")
  vim.cmd("normal! ci[ready && near")

  find("ready\\>")
  seen.hover = ask("textDocument/hover").contents.value

  find("Ball\\>")
  vim.lsp.buf.definition()
  wait("the definition", function() return vim.fn.expand("%:t") == "world.aseme" end)
  seen.definition = vim.fn.getline(".")
  vim.cmd("edit team.aseme")

  find("Kick\\>")
  vim.lsp.buf.rename("Shoot")
  wait("the new name", function() return lines():find("Shoot") ~= nil end)
  seen.renamed = lines()

  find("srm player")
  vim.cmd("normal! A     ")
  vim.cmd("normal! jI      ")
  if vim.lsp.buf.format then
    vim.lsp.buf.format({ timeout_ms = MOST })
  else
    vim.lsp.buf.formatting_sync(nil, MOST)
  end
  seen.formatted = lines()
  wait("no mistake", function() return #vim.diagnostic.get(0) == 0 end)

  vim.cmd("wall")
  seen.clients = {}
  for _, client in ipairs((vim.lsp.get_clients or vim.lsp.get_active_clients)()) do
    table.insert(seen.clients, { client.name, client.config.root_dir })
  end
end

local fine, problem = xpcall(walk, debug.traceback)
seen.problem = not fine and tostring(problem) or nil
vim.fn.writefile({ vim.json and vim.json.encode(seen) or vim.fn.json_encode(seen) }, vim.env.NVIM_RESULT)
vim.cmd("qall!")
