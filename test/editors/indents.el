;;; indents.el --- Indentation of scc-mode -*- lexical-binding: t -*-

;; emacs -Q --batch -l scc-mode.el -l indents.el -- FILE…

;; The canonical layout of `scc fmt' is the one that `indent-region' gives: lines of FILEs whose indentation it would change
;; are told. The last line is 'N passed, N failed', of lines.

(let ((passed 0) (failed 0))
  (dolist (file (remove "--" command-line-args-left))
    (with-temp-buffer
      (insert-file-contents file)
      (scc-mode)
      (goto-char (point-min))
      (while (not (eobp))
        (back-to-indentation)
        (let ((wanted (if (looking-at "$") 0 (current-column)))
              (got (progn (scc-mode-indent-line) (current-indentation))))
          (if (= wanted got) (setq passed (1+ passed))
            (setq failed (1+ failed))
            (when (< failed 20)
              (message "%s:%d: %d, not %d: %s" file (line-number-at-pos) got wanted
                       (string-trim (thing-at-point 'line t)))))
          (indent-line-to wanted))
        (forward-line 1))))
  (setq command-line-args-left nil)
  (message "%d passed, %d failed" passed failed)
  (kill-emacs (if (and (> passed 0) (= failed 0)) 0 1)))
