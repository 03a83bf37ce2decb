;;; faces.el --- The faces of scc-mode at places of files -*- lexical-binding: t -*-

;; emacs -Q --batch -l scc-mode.el -l faces.el -- ASKED ANSWER

;; The file ASKED has a line of JSON for each model: its path, and its places, each as the number of its character from 1.
;; ANSWER has a line of JSON for each: the face at each place.

(require 'json)
(require 'font-lock)

(let ((asked (pop command-line-args-left)) (answer nil))
  (when (equal asked "--") (setq asked (pop command-line-args-left)))
  (setq answer (pop command-line-args-left))
  (with-temp-file answer
    (dolist (line (split-string (with-temp-buffer (insert-file-contents asked) (buffer-string)) "\n" t))
      (let* ((json (json-parse-string line :array-type 'list))
             (faces (with-temp-buffer
                      (insert-file-contents (gethash "path" json))
                      (scc-mode)
                      (font-lock-ensure)
                      (mapcar (lambda (at)
                                (let ((face (get-text-property at 'face)))
                                  (symbol-name (if (consp face) (car face) face))))
                              (gethash "places" json)))))
        (insert (json-encode faces) "\n")))))
