(* The part of the grammar that lists, names and expressions are; parser.mly has its tokens and the rest. *)

%%

(* Lists, left recursive: the stack stays flat *)

%public reversed(X):
| { [] }
| xs = reversed(X) x = X { x :: xs }

%public %inline many(X): xs = reversed(X) { List.rev xs }

%public comma_separated(X):
| x = X { [ x ] }
| xs = comma_separated(X) COMMA x = X { x :: xs }

%public %inline comma_list(X): xs = comma_separated(X) { List.rev xs }

%public %inline optional_list(X):
| { [] }
| xs = comma_list(X) { xs }

(* Names and paths *)

(* A letter of the temporal operators is a name wherever it cannot be one of them, and `only` where it cannot be the
   word before a feature. *)

%public common_name:
| n = NAME { at $loc n }
| n = LETTER { at $loc n }
| U { at $loc "U" }
| MOD { at $loc "mod" }
| HULL { at $loc "hull" }
| AS { at $loc "as" }
| WHERE { at $loc "where" }
| BOND { at $loc "bond" }
| MASS { at $loc "mass" }
| EVENT { at $loc "event" }
| DYNAMICS { at $loc "dynamics" }
| COLLISIONS { at $loc "collisions" }
| BINDING { at $loc "binding" }
| BONDS { at $loc "bonds" }
| BLOCKED { at $loc "blocked" }
| SNAP { at $loc "snap" }
| GRID { at $loc "grid" }
| WELD { at $loc "weld" }
| ORIENT { at $loc "orient" }
| MERGE { at $loc "merge" }
| UNION { at $loc "union" }
| DECOMPOSE { at $loc "decompose" }
| RESOLUTION { at $loc "resolution" }
| ROUND { at $loc "round" }
| STEADY { at $loc "steady" }
| PUSH { at $loc "push" }
| ABSORB { at $loc "absorb" }

%public plain_name:
| n = common_name { n }
| ONLY { at $loc "only" }

%public %inline quantifying_letter:
| A { at $loc "A" }
| E { at $loc "E" }

%public %inline operator_word:
| AF { at $loc "AF" }
| AG { at $loc "AG" }
| AX { at $loc "AX" }
| EF { at $loc "EF" }
| EG { at $loc "EG" }
| EX { at $loc "EX" }

(* Before the colon of a quantifier there is no label. *)
%public bracket:
| LBRACKET { () }
| LABEL_BRACKET { () }

(* Where an expression may stand: `A[` is followed by indices or by `f U g]`, which the bracket after tells. *)
%public term_name:
| n = plain_name %prec OPEN { n }
| n = quantifying_letter %prec OPEN { n }

%public name: n = term_name | n = operator_word { n }

%public member_name: n = common_name | n = quantifying_letter | n = operator_word { n }

%public indexed(N):
| name = N { { name; indices = [] } }
| name = N LBRACKET indices = comma_list(expr) RBRACKET { { name; indices } }

%public segment: s = indexed(name) { s }

(* A bracket after a name has its indices: before the outcome that `P >= (q) [ … ]` measures, a name needs brackets
   of its own. *)
%public term_segment:
| name = term_name { { name; indices = [] } }
| name = plain_name bracket indices = comma_list(expr) RBRACKET { { name; indices } }
| name = quantifying_letter bracket indices = comma_list(expr) RBRACKET { { name; indices } }

%public segments(N):
| s = indexed(N) { [ s ] }
| ss = segments(N) DOT s = segment { s :: ss }

%public path: ss = segments(name) { at $loc (List.rev ss) }

%public later_segment:
| name = name %prec OPEN { { name; indices = [] } }
| name = name bracket indices = comma_list(expr) RBRACKET { { name; indices } }

%public term_segments:
| s = term_segment { [ s ] }
| ss = term_segments DOT s = later_segment { s :: ss }

%public term_path: ss = term_segments { at $loc (List.rev ss) }

%public polar_name:
| n = name { (false, n) }
| TILDE n = name { (true, n) }
| n = BARRED { (true, at $loc n) }

%public call(N): f = N LPAREN es = optional_list(expr) RPAREN { at $loc (Apply (f, es)) }

(* A vector in brackets: three numbers, or an expression. *)
%public closed_vector:
| LPAREN x = expr COMMA y = expr COMMA z = expr RPAREN { at $loc (Vector (x, y, z)) }
| LPAREN e = expr RPAREN { e }

(* One that an operator may follow which is not its own. *)
%public vector:
| v = closed_vector { v }
| ss = plain_path { at $loc (Path (at $loc (List.rev ss))) }
| c = call(name) { c }

%public quadruple: LPAREN w = expr COMMA x = expr COMMA y = expr COMMA z = expr RPAREN { (w, x, y, z) }

event_word:
| e = NAME { e }
| ABSORB { "absorb" }

(* Numbers, truth values and formulas *)

%public %inline arithmetic_operator:
| PLUS { Add }
| MINUS { Sub }
| STAR { Mul }
| SLASH { Div }
| MOD { Mod }

%public %inline operator:
| o = arithmetic_operator { o }
| LT { Lt }
| LE { Le }
| GT { Gt }
| GE { Ge }
| EQ { Eq }
| NE { Ne }
| AND { And }
| OR { Or }
| IMPLIES { Implies }

%public %inline english:
| POSSIBLY { Possibly }
| ALWAYS { Always }
| EVENTUALLY { Eventually }

%public %inline letters:
| AF { Finally Ast.A }
| EF { Finally Ast.E }
| AG { Globally Ast.A }
| EG { Globally Ast.E }

%public %inline next:
| AX { Next Ast.A }
| EX { Next Ast.E }

%public %inline path_quantifier:
| A { Ast.A }
| E { Ast.E }

%public %inline quantifier:
| FORALL { Forall }
| EXISTS { Exists }

filter: IF c = expr { c }

%public bounds: low = expr DOTDOT high = expr filter = ioption(filter) { { low; high; filter } }

over:
| e = expr { Bodies e }
| b = bounds { Numbers b }

%public bound:
| LBRACKET LE t = expr RBRACKET { At_most t }
| LBRACKET a = expr COMMA b = expr RBRACKET { Between (a, b) }

%public %inline threshold:
| LT { Lt }
| LE { Le }
| GT { Gt }
| GE { Ge }

outcome:
| e = expr { Does e }
| f = expr U b = ioption(bound) g = expr { Goes_until (f, b, g) }
| e = expr AT t = expr { Has_at (e, t) }

%public expr:
| q = NUMBER { at $loc (Number q) }
| TRUE { at $loc True }
| FALSE { at $loc False }
| p = term_path { at $loc (Path p) }
| TILDE n = name { at $loc (Co n) }
| n = BARRED { at $loc (Co (at $loc n)) }
| c = call(term_name) { c }
| c = call(term_name) DOT axis = name { at $loc (Component (c, axis)) }
| ss = term_segments DOT f = name LPAREN es = optional_list(expr) RPAREN
    { at $loc (Apply_in (at $loc(ss) (List.rev ss), f, es)) }
| BEHAVIOUR LPAREN es = optional_list(expr) RPAREN { at $loc (Apply (at $loc($1) "behaviour", es)) }
| v = closed_vector { v }
| v = closed_vector DOT axis = name { at $loc (Component (v, axis)) }
| COUNT LPAREN p = name IN t = over COLON e = expr RPAREN { at $loc (Quantified (Count, p, t, e)) }
| EVENT e = event_word { at $loc (Event (at $loc(e) e, [])) }
| EVENT e = event_word LPAREN es = optional_list(expr) RPAREN { at $loc (Event (at $loc(e) e, es)) }
| q = path_quantifier bracket f = expr U b = ioption(bound) g = expr RBRACKET
    { at $loc (Until (q, f, b, g)) }
| m = expr o = threshold e = expr bracket w = outcome RBRACKET { at $loc (Measured (m, Some (o, e), w)) }
| m = expr EQ QUESTION bracket w = outcome RBRACKET { at $loc (Measured (m, None, w)) }
| MINUS e = expr %prec NEGATION { at $loc (Neg e) }
| NOT e = expr { at $loc (Not e) }
| l = expr o = operator r = expr { at $loc (Binary (o, l, r)) }
| f = expr LEADS_TO b = ioption(bound) g = expr %prec LEADS_TO { at $loc (Leads_to (f, b, g)) }
| f = expr LEADS_TO g = expr WITHIN d = expr %prec WITHIN_ARGUMENT
    { at $loc (Leads_to (f, Some (Within d), g)) }
| IF c = expr THEN t = expr ELSE e = expr %prec OPEN { at $loc (If (c, t, e)) }
| q = quantifier p = name IN t = over COLON e = expr %prec OPEN { at $loc (Quantified (q, p, t, e)) }
| t = english b = ioption(bound) e = expr %prec OPEN { at $loc (Temporal (t, b, e)) }
| t = english e = expr WITHIN d = expr %prec WITHIN_ARGUMENT { at $loc (Temporal (t, Some (Within d), e)) }
| t = letters b = ioption(bound) e = expr %prec NOT { at $loc (Temporal (t, b, e)) }
| t = next e = expr %prec NOT { at $loc (Temporal (t, None, e)) }

(* Attributes: arithmetic alone, and no index outside brackets, so that `<` after one opens a bond and `[` a
   behaviour *)

%public plain_path:
| n = name { [ { name = n; indices = [] } ] }
| ss = plain_path DOT n = name { { name = n; indices = [] } :: ss }

%public arithmetic:
| q = NUMBER { at $loc (Number q) }
| ss = plain_path { at $loc (Path (at $loc (List.rev ss))) }
| c = call(name) { c }
| c = call(name) DOT axis = name { at $loc (Component (c, axis)) }
| v = closed_vector { v }
| v = closed_vector DOT axis = name { at $loc (Component (v, axis)) }
| MINUS e = arithmetic %prec NEGATION { at $loc (Neg e) }
| l = arithmetic o = arithmetic_operator r = arithmetic { at $loc (Binary (o, l, r)) }
