;;; aseme-mode.el --- Multi-agent systems in text  -*- lexical-binding: t; -*-

;; Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
;; Package-Requires: ((emacs "27.1"))
;; SPDX-License-Identifier: MIT

;;; Commentary:

;; (require 'aseme-mode)
;; (add-hook 'aseme-mode-hook #'eglot-ensure)   ; the language server, `asemec lsp'

;;; Code:

(require 'seq)
(require 'subr-x)
(require 'url-util)

(defgroup aseme nil "Multi-agent systems in text." :group 'languages)

(defcustom aseme-command '("asemec")
  "The program asemec, with arguments if it needs any."
  :type '(repeat string))

(defcustom aseme-indent 2
  "Columns of a step of indentation."
  :type 'integer :safe #'integerp)

(defconst aseme-entries
  '("abstract" "activities" "actor" "aip" "algorithm" "capability" "clause" "control" "data" "engage"
    "enter" "enum" "environment" "exit" "finish" "function" "functionality" "given" "goal" "import"
    "includes" "language" "leave" "let" "liveness" "message" "modules" "on" "optional" "outcome"
    "participant" "permissions" "plays" "property" "receives" "repeat" "repeated" "result" "resume" "role"
    "sag" "scenario" "sends" "signal" "skip" "srm" "start" "state" "statechart" "suc" "system" "team"
    "technology" "topic" "usecase" "var")
  "Words with which a declaration or an entry begins.")

(defconst aseme-clauses
  '("AND" "BASIC" "CONDITION" "END" "OR" "START" "above" "abstract" "activity" "after" "and" "around" "as"
    "async" "at" "before" "below" "busy" "by" "delay" "depends" "else" "ends" "every" "except" "expires"
    "external" "for" "from" "guarantees" "human" "ignores" "includes" "leads" "legacy" "list" "lost"
    "most" "never" "no" "not" "of" "on" "one" "or" "persist" "process" "queued" "radio" "raise"
    "read_messages" "reads" "realises" "repeatedly" "reply_by" "send" "sent" "simulated" "srm" "step"
    "system" "takes" "thread" "three" "to" "two" "under" "uses" "waits" "weight" "when" "with" "within"
    "write_messages" "writes")
  "Words with which a clause begins, and those of expressions.")

(defconst aseme-blocks
  '("actor" "aip" "control" "enum" "functionality" "message" "participant" "srm" "statechart" "team"
    "topic")
  "Words of blocks that have a name.")

(defconst aseme-types '("bool" "bytes" "double" "duration" "int" "string"))

(defconst aseme-constants '("false" "true"))

(defvar aseme-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?_ "_" table)
    (dolist (sign '(?= ?< ?> ?+ ?- ?| ?& ?~ ?! ?# ?@ ?:))
      (modify-syntax-entry sign "." table))
    table))

(defconst aseme-font-lock-keywords
  `((,(concat "\\(?:^\\|[{}]\\)[ \t]*\\(" (regexp-opt aseme-entries 'symbols) "\\)")
     1 font-lock-keyword-face)
    (,(concat (regexp-opt aseme-blocks 'symbols) "[ \t]+\\([A-Za-z_][A-Za-z0-9_]*\\)")
     2 font-lock-type-face)
    ("^[ \t]*\\([A-Za-z_][A-Za-z0-9_]*\\)[ \t]*=[^=]" 1 font-lock-function-name-face)
    ("\\.[ \t]*[A-Za-z_][A-Za-z0-9_]*" . 'default)
    (,(regexp-opt aseme-clauses 'symbols) . font-lock-builtin-face)
    (,(regexp-opt aseme-types 'symbols) . font-lock-type-face)
    (,(regexp-opt aseme-constants 'symbols) . font-lock-constant-face)))

(defun aseme--begins-p ()
  "Whether point, at the first character of a line, is where a declaration or an entry begins."
  (let ((before (save-excursion
                  (forward-comment (- (point)))
                  (char-before))))
    (or (memq before '(nil ?{ ?}))
        (looking-at-p "}")
        (and (looking-at-p "[A-Za-z_][A-Za-z0-9_]*[ \t]*=[^=]") (not (memq before '(?\; ?, ?/)))))))

(defun aseme-indent-line ()
  "Indent by the braces that are open; a line that is continued keeps what it is aligned with."
  (interactive)
  (let* ((state (save-excursion (syntax-ppss (line-beginning-position))))
         (open (seq-count (lambda (place) (eq (char-after place) ?{)) (nth 9 state)))
         (base (save-excursion
                 (back-to-indentation)
                 (* aseme-indent (max 0 (- open (if (looking-at-p "}") 1 0))))))
         (aligned (save-excursion
                    (back-to-indentation)
                    (and (not (eolp)) (> (current-column) base) (not (aseme--begins-p)))))
         (column (if (or (nth 8 state) aligned) (current-indentation) base)))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;;###autoload
(define-derived-mode aseme-mode prog-mode "ASEME"
  "The mode for .aseme files."
  (setq-local comment-start "// "
              comment-end ""
              comment-start-skip "//+\\s-*\\|/\\*+\\s-*"
              indent-tabs-mode nil
              ;; The bracket of the operator `[>' has no other one.
              syntax-propertize-function (syntax-propertize-rules ("\\(\\[\\)>" (1 ".")))
              indent-line-function #'aseme-indent-line
              compile-command (mapconcat #'identity (append aseme-command '("check")) " ")
              font-lock-defaults '(aseme-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.aseme\\'" . aseme-mode))

;; From the Python class of an activity to the model. (Back leads `eglot-find-implementation'.)
(declare-function eglot-current-server "eglot")
(declare-function jsonrpc-request "jsonrpc")
(declare-function xref-make "xref")
(declare-function xref-make-file-location "xref")
(declare-function xref-show-xrefs "xref")

(defun aseme--server ()
  "The language server of an .aseme file that is open in the project of this file."
  (let ((file (file-truename buffer-file-name)) found)
    (dolist (buffer (buffer-list) found)
      (with-current-buffer buffer
        (when (and (derived-mode-p 'aseme-mode) buffer-file-name (fboundp 'eglot-current-server)
                   (string-prefix-p
                    (file-truename (or (locate-dominating-file default-directory "pyproject.toml")
                                       default-directory))
                    file))
          (setq found (or found (eglot-current-server))))))))

(defun aseme--xref (place)
  "What xref shows for PLACE, a location of the language server."
  (let* ((file (url-unhex-string (substring (plist-get place :uri) (length "file://"))))
         (start (plist-get (plist-get place :range) :start))
         (line (plist-get start :line))
         (text (with-current-buffer (find-file-noselect file)
                 (save-excursion
                   (save-restriction
                     (widen)
                     (goto-char (point-min))
                     (forward-line line)
                     (string-trim (buffer-substring (point) (line-end-position))))))))
    (xref-make text (xref-make-file-location file (1+ line) (plist-get start :character)))))

;;;###autoload
(defun aseme-where ()
  "Show where the models have the activity whose Python class point is in.
Some .aseme file of the project must be open, with its language server."
  (interactive)
  (let* ((server (or (aseme--server)
                     (user-error "No language server: open an .aseme file of the project first")))
         (uri (concat "file://" (url-encode-url (file-truename buffer-file-name))))
         (places (jsonrpc-request
                  server :textDocument/references
                  (list :textDocument (list :uri uri)
                        :position (list :line (1- (line-number-at-pos nil t))
                                        :character (- (point) (line-beginning-position)))
                        :context '(:includeDeclaration t)))))
    (when (seq-empty-p places) (user-error "This is not a class of an activity"))
    (let ((found (mapcar #'aseme--xref places)))
      (xref-show-xrefs (lambda () found) nil))))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs
               (cons 'aseme-mode (lambda (&rest _) (append aseme-command '("lsp"))))))

(provide 'aseme-mode)
;;; aseme-mode.el ends here
