;;; scc-mode.el --- Models of the Shape Calculus -*- lexical-binding: t -*-

;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages

;;; Commentary:

;; A mode for models of scc: colours, indentation, comments, `compile' and, by eglot, the language server `scc lsp'.
;; editors/words writes the lists of words.

;;; Code:

(require 'compile)

(defgroup scc nil "Models of the Shape Calculus." :group 'languages)

(defcustom scc-program "scc"
  "The program that checks models."
  :type 'string
  :group 'scc)

(defcustom scc-indent-offset 2
  "How many columns a level is indented."
  :type 'integer
  :safe #'integerp
  :group 'scc)

(defconst scc-mode-keywords
  '(
    ;; words: keyword setting
    "absorb" "as" "at" "behaviour" "bond" "check" "choose" "compound" "decompose" "eps" "faces" "fixed" "for"
    "glue" "grid" "hull" "import" "in" "inertial" "let" "mass" "matrix" "merge" "mesh" "model" "motion"
    "network" "omega" "on" "only" "orient" "param" "part" "process" "push" "quaternion" "rho" "rotate" "scale"
    "scaled" "shape" "snap" "spin" "translate" "union" "velocity" "vertices" "weight" "weld" "where" "binding"
    "blocked" "bonds" "collisions" "dynamics" "local" "resolution" "round" "split_step" "steady" "timestep"
    ;; words: end
    ))

(defconst scc-mode-operators
  '(
    ;; words: operator temporal
    "and" "count" "else" "exists" "forall" "if" "mod" "not" "or" "then" "AF" "AG" "AX" "EF" "EG" "EX" "always"
    "event" "eventually" "leads_to" "possibly" "within"
    ;; words: end
    ))

(defconst scc-mode-constants
  '(
    ;; words: literal
    "false" "nil" "true"
    ;; words: end
    ))

(defconst scc-mode-functions
  '(
    ;; words: function solid
    "abs" "ceil" "cross" "diffuse" "dot" "floor" "max" "min" "sign" "antiprism" "box" "prism" "pyramid"
    ;; words: end
    ))

(defconst scc-mode-atoms
  '(
    ;; words: atom
    "angular" "bound" "distance2" "dt" "energy" "gone" "momentum" "offers" "processes" "quiescent" "same"
    "size" "speed2" "spin2" "time" "touching" "vx" "vy" "vz" "wx" "wy" "wz" "x" "y" "z"
    ;; words: end
    ))

(defconst scc-mode-name "[A-Za-z][A-Za-z0-9_']*")

(defvar scc-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?' "w" table)
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23n" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?\" "\"" table)
    (dolist (mark '(?< ?> ?= ?+ ?- ?~ ?| ?? ?!))
      (modify-syntax-entry mark "." table))
    table)
  "Letters, digits, `_' and the apostrophe make a name.
There are two kinds of comments, of which one nests.")

(defun scc-mode--words (words)
  "A pattern of these WORDS."
  (concat "\\<" (regexp-opt words t) "\\>"))

(defconst scc-mode-font-lock
  `(;; The name of a channel, whatever word it is.
    (,(concat "[<⟨~]\\s-*~?\\(" scc-mode-name "\\)\\s-*,\\s-*{") 1 font-lock-type-face)
    (,(concat "\\<\\(?:shape\\|compound\\)\\s-+\\(" scc-mode-name "\\)") 1 font-lock-type-face)
    (,(concat "\\<\\(?:behaviour\\|check\\)\\s-+\\(" scc-mode-name "\\)") 1 font-lock-function-name-face)
    (,(concat "\\<\\(?:process\\|fixed\\|part\\|param\\|let\\|model\\)\\s-+\\(" scc-mode-name "\\)")
     1 font-lock-variable-name-face)
    (,(scc-mode--words scc-mode-keywords) . font-lock-keyword-face)
    (,(scc-mode--words scc-mode-operators) . font-lock-keyword-face)
    (,(scc-mode--words scc-mode-constants) . font-lock-constant-face)
    ;; Letters are words only where an operator stands.
    ("\\<\\([AE]\\)\\s-*\\[" 1 font-lock-keyword-face)
    ("[]) \t]\\(U\\)\\_>\\s-*[[(A-Za-z0-9-]" 1 font-lock-keyword-face)
    ("\\<\\([PE]\\(?:min\\|max\\)?\\)\\s-*[<>=]" 1 font-lock-builtin-face)
    (,(concat (scc-mode--words scc-mode-functions) "\\s-*(") 1 font-lock-builtin-face)
    (,(scc-mode--words scc-mode-atoms) . font-lock-builtin-face)
    ("\\<\\(?:2\\^-[0-9]+\\|[0-9]+\\(?:\\.[0-9]+\\)?\\(?:[eE][+-]?[0-9]+\\)?\\)\\>" . font-lock-constant-face)
    ("[ωρϱεϵ]" . font-lock-keyword-face)))

(defconst scc-mode-beginnings
  (concat "\\(?:"
          (regexp-opt '("model" "import" "param" "timestep" "split_step" "resolution" "shape" "compound" "behaviour" "process"
                        "fixed" "bond" "for" "network" "motion" "let" "check" "part" "glue" "vertices" "faces"))
          "\\|"
          (regexp-opt '("dynamics" "collisions" "binding" "bonds" "blocked" "round"))
          "\\s-+" scc-mode-name "\\)\\_>")
  "What begins a line of its own: a declaration, or a piece of one.")

(defun scc-mode--in-block (base)
  "The column of a line in braces; BASE is that of the line that opens them."
  (cond
   ((looking-at "[])}]") base)
   ((or (looking-at scc-mode-beginnings) (looking-at "//\\|/\\*\\|$")) (+ base scc-indent-offset))
   ;; Points and faces go on below the first of them.
   ((save-excursion
      (let ((open (nth 1 (syntax-ppss))))
        (and (re-search-backward "\\_<\\(?:vertices\\|faces\\)\\s-+" open t)
             (progn (goto-char (match-end 0)) (current-column))))))
   ;; The rest of a declaration in a loop.
   ((save-excursion
      (let ((open (nth 1 (syntax-ppss))))
        (and (re-search-backward scc-mode-beginnings open t) (eq (nth 1 (syntax-ppss)) open))))
    (+ base (* 2 scc-indent-offset)))
   (t (+ base scc-indent-offset))))

(defun scc-mode--column ()
  "The column that the present line should have."
  (save-excursion
    (back-to-indentation)
    (let* ((state (syntax-ppss))
           (open (nth 1 state)))
      (cond
       ((nth 8 state) (current-indentation))
       ((and open (or (eq (char-after open) ?{)
                      (save-excursion (goto-char (1+ open)) (looking-at "\\s-*\\(?://.*\\)?$"))))
        (scc-mode--in-block (save-excursion (goto-char open) (current-indentation))))
       (open (save-excursion
               (let ((closing (looking-at "[])}]")))
                 (goto-char open)
                 (+ (current-column) (if closing 0 1)))))
       ((or (looking-at scc-mode-beginnings) (looking-at "//\\|/\\*\\|$")) 0)
       ;; The rest of a declaration; a prefix goes on farther right.
       ((save-excursion (skip-chars-backward " \t\n") (eq (char-before) ?.)) (* 3 scc-indent-offset))
       (t scc-indent-offset)))))

(defun scc-mode-indent-line ()
  "Indent the present line.
Declarations stand at the margin, what is in braces a level deeper."
  (interactive)
  (let ((column (scc-mode--column)))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

(defvar scc-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-c") #'scc-check)
    (define-key map (kbd "C-c C-f") #'scc-format-buffer)
    map))

(defun scc-check ()
  "Check the model of this buffer by `compile'."
  (interactive)
  (compile (concat (shell-quote-argument scc-program) " check " (shell-quote-argument (buffer-file-name)))))

(defun scc-format-buffer ()
  "Give the model of this buffer the canonical layout.
A model with errors stays as it is."
  (interactive)
  (let ((layout (generate-new-buffer " *scc fmt*")) (file (make-temp-file "scc" nil ".sc")))
    (unwind-protect
        (progn
          (write-region nil nil file nil 'silent)
          (if (zerop (call-process scc-program nil (list layout nil) nil "fmt" file))
              (replace-buffer-contents layout)
            (message "scc: the model has errors")))
      (delete-file file)
      (kill-buffer layout))))

;;;###autoload
(define-derived-mode scc-mode prog-mode "scc"
  "Models of the Shape Calculus."
  (setq-local comment-start "// ")
  (setq-local comment-end "")
  (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)\\s-*")
  (setq-local font-lock-defaults '(scc-mode-font-lock))
  (setq-local indent-line-function #'scc-mode-indent-line)
  (setq-local indent-tabs-mode nil)
  (setq-local imenu-generic-expression
              `((nil ,(concat "^\\s-*\\(?:shape\\|compound\\|behaviour\\|process\\|fixed\\|check\\)\\s-+\\("
                              scc-mode-name "\\)")
                     1)))
  (setq-local compilation-error-regexp-alist
              '(("^\\(.+?\\):\\([0-9]+\\):\\([0-9]+\\): \\(?:error\\|\\(warning\\)\\)\\[SC[0-9]+\\]" 1 2 3 (4)))))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.sc\\'" . scc-mode))

;; Eglot is part of Emacs since 29.
(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs `(scc-mode . (,scc-program "lsp"))))

(provide 'scc-mode)
;;; scc-mode.el ends here
