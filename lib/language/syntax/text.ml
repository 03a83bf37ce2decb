open Ast

(* {1 Expressions}

   Levels of precedence, as in the grammar: what reaches to the right as far as it can is loosest. *)

let open_ended = 0
let leads_to = 1
let implies = 2
let either = 3
let both = 4
let prefix = 5
let comparison = 6
let sum = 7
let product = 8
let negation = 9
let atom = 10

(* Of an operator: its level, and those that its operands need. *)
let levels = function
  | Implies -> (implies, either, implies)
  | Or -> (either, either, both)
  | And -> (both, both, prefix)
  | Lt | Le | Gt | Ge | Eq | Ne -> (comparison, sum, sum)
  | Add | Sub -> (sum, sum, product)
  | Mul | Div | Mod -> (product, product, negation)

let level e =
  match e.it with
  | Number q ->
    if Option.is_none (Numerals.decimal (Q.abs q)) then product else if Q.sign q < 0 then negation else atom
  | True | False | Path _ | Co _ | Apply _ | Apply_in _ | Component _ | Vector _ | Quantified (Count, _, _, _)
  | Until _ | Measured (_, None, _) | Event _ -> atom
  | Measured (_, Some _, _) -> comparison
  | Neg _ -> negation
  | Not _ | Temporal ((Next _ | Finally _ | Globally _), _, _) -> prefix
  | Leads_to _ -> leads_to
  | Binary (o, _, _) -> let own, _, _ = levels o in own
  | If _ | Quantified ((Forall | Exists), _, _, _) | Temporal ((Possibly | Always | Eventually), _, _) ->
    open_ended

let operator = function
  | Add -> " + " | Sub -> " - " | Mul -> "*" | Div -> "/" | Mod -> " mod "
  | Lt -> " < " | Le -> " <= " | Gt -> " > " | Ge -> " >= " | Eq -> " = " | Ne -> " != "
  | And -> " and " | Or -> " or " | Implies -> " => "

let quantified_by = function A -> "A" | E -> "E"

let temporal = function
  | Possibly -> "possibly"
  | Always -> "always"
  | Eventually -> "eventually"
  | Next q -> quantified_by q ^ "X"
  | Finally q -> quantified_by q ^ "F"
  | Globally q -> quantified_by q ^ "G"

let is_english = function Possibly | Always | Eventually -> true | Next _ | Finally _ | Globally _ -> false

let list b each xs =
  List.iteri
    (fun i x ->
       if i > 0 then Buffer.add_string b ", ";
       each b x)
    xs

let rec add_expr at_least b e =
  if level e < at_least then begin
    Buffer.add_char b '(';
    add_bare b e;
    Buffer.add_char b ')'
  end
  else add_bare b e

and add_bare b e =
  let str = Buffer.add_string b in
  match e.it with
  | Number q -> str (Numerals.number q)
  | True -> str "true"
  | False -> str "false"
  | Path p -> add_path b p
  | Co n -> str "~"; str n.it
  | Apply (f, es) -> str f.it; str "("; list b (add_expr open_ended) es; str ")"
  | Apply_in (p, f, es) ->
    add_path b p;
    str "."; str f.it; str "("; list b (add_expr open_ended) es; str ")"
  | Component ({ it = Apply _ | Vector _; _ } as e, axis) -> add_bare b e; str "."; str axis.it
  | Component (e, axis) -> str "("; add_expr open_ended b e; str ")."; str axis.it
  | Vector (x, y, z) -> str "("; list b (add_expr open_ended) [ x; y; z ]; str ")"
  | Neg e -> str "-"; add_expr negation b e
  | Not e -> str "not "; add_expr prefix b e
  | Binary (o, l, r) ->
    let _, left, right = levels o in
    add_expr left b l;
    str (operator o);
    add_expr right b r
  | If (c, t, e) ->
    str "if "; add_expr open_ended b c;
    str " then "; add_expr open_ended b t;
    str " else "; add_expr open_ended b e
  | Quantified (Count, p, t, e) -> str "count("; add_quantified b p t e; str ")"
  | Quantified (Forall, p, t, e) -> str "forall "; add_quantified b p t e
  | Quantified (Exists, p, t, e) -> str "exists "; add_quantified b p t e
  | Temporal (t, Some (Within d), e) when is_english t ->
    str (temporal t); str " "; add_expr implies b e; str " within "; add_expr sum b d
  | Temporal (t, bound, e) ->
    str (temporal t);
    Option.iter (add_bound b) bound;
    str " ";
    add_expr (if is_english t then open_ended else prefix) b e
  | Until (q, f, bound, g) ->
    str (quantified_by q); str "["; add_expr open_ended b f; str " U";
    Option.iter (add_bound b) bound;
    str " "; add_expr open_ended b g; str "]"
  | Measured (m, test, outcome) ->
    add_expr atom b m;
    (match test with
     | None -> str " = ?"
     | Some (o, e) -> str (operator o); add_bracketed b e);
    str " [ ";
    add_outcome b outcome;
    str " ]"
  | Leads_to (f, bound, g) ->
    add_expr implies b f; str " ";
    add_consequence b (bound, g)
  | Event (e, []) -> str "event "; str e.it
  | Event (e, es) -> str "event "; str e.it; str "("; list b (add_expr open_ended) es; str ")"

(* Before a bracket that does not belong to it: a name would take that for its indices. *)
and add_bracketed b e =
  match e.it with
  | Number _ | Neg _ | Binary ((Add | Sub | Mul | Div | Mod), _, { it = Number _; _ }) -> add_expr sum b e
  | _ -> add_expr (atom + 1) b e

and add_outcome b = function
  | Does e -> add_expr open_ended b e
  | Goes_until (f, bound, g) ->
    add_expr open_ended b f; Buffer.add_string b " U";
    Option.iter (add_bound b) bound;
    Buffer.add_char b ' '; add_expr open_ended b g
  | Has_at (e, t) -> add_expr open_ended b e; Buffer.add_string b " at "; add_expr open_ended b t

and add_consequence b (bound, g) =
  let str = Buffer.add_string b in
  str "leads_to";
  (match bound with
   | Some (At_most _ | Between _) -> Option.iter (add_bound b) bound
   | None | Some (Within _) -> ());
  str " ";
  add_expr implies b g;
  (match bound with
   | Some (Within d) -> str " within "; add_expr sum b d
   | None | Some (At_most _ | Between _) -> ())

and add_quantified b (p : name) over e =
  Buffer.add_string b (p.it ^ " in ");
  (match over with
   | Bodies t -> add_expr open_ended b t
   | Numbers r -> add_bounds b r);
  Buffer.add_string b ": ";
  add_expr open_ended b e

and add_bounds b { low; high; filter } =
  add_expr open_ended b low;
  Buffer.add_string b "..";
  add_expr open_ended b high;
  Option.iter
    (fun c ->
       Buffer.add_string b " if ";
       add_expr open_ended b c)
    filter

and add_bound b bound =
  let str = Buffer.add_string b in
  match bound with
  | Within t | At_most t -> str "[<= "; add_expr open_ended b t; str "]"
  | Between (t, u) -> str "["; list b (add_expr open_ended) [ t; u ]; str "]"

and add_segment b s =
  Buffer.add_string b s.name.it;
  match s.indices with
  | [] -> ()
  | es ->
    Buffer.add_char b '[';
    list b (add_expr open_ended) es;
    Buffer.add_char b ']'

and add_path b p =
  List.iteri
    (fun i s ->
       if i > 0 then Buffer.add_char b '.';
       add_segment b s)
    p.it

let written add x =
  let b = Buffer.create 80 in
  add b x;
  Buffer.contents b

let expr e = written (add_expr open_ended) e
let bounds r = written add_bounds r
let condition f = written (add_expr implies) f
let consequence bound g = written add_consequence (bound, g)

type side = Left | Right

let needs_parentheses o side e =
  let _, left, right = levels o in
  level e < (match side with Left -> left | Right -> right)

let segment s = written add_segment s
let path p = written add_path p

let tuple es = "(" ^ String.concat ", " (List.map expr es) ^ ")"
let quadruple (w, x, y, z) = tuple [ w; x; y; z ]

(* Whether an expression prints as arithmetic with no index outside brackets: what an attribute may hold. *)
let rec is_arithmetic at_least e =
  level e < at_least
  ||
  match e.it with
  | Number _ -> true
  | Path p -> List.for_all (fun (s : segment) -> match s.indices with [] -> true | _ :: _ -> false) p.it
  | Apply (f, _) -> not (String.equal f.it "behaviour")
  | Vector _ | Component _ -> true
  | Neg e -> is_arithmetic negation e
  | Binary (((Add | Sub | Mul | Div | Mod) as o), l, r) ->
    let _, left, right = levels o in
    is_arithmetic left l && is_arithmetic right r
  | _ -> false

let arithmetic e = if is_arithmetic open_ended e then expr e else "(" ^ expr e ^ ")"

let closed_vector e = match e.it with Vector _ -> expr e | _ -> "(" ^ expr e ^ ")"

let vector e =
  match e.it with
  | (Path _ | Apply _) when is_arithmetic open_ended e -> expr e
  | _ -> closed_vector e

let law_of_all e = match e.it with If _ | Apply _ -> expr e | _ -> closed_vector e

let applied opening es closing =
  match es with
  | [] -> ""
  | _ :: _ -> opening ^ String.concat ", " (List.map expr es) ^ closing

let reference (r : reference) =
  let qualifier = match r.qualifier with None -> "" | Some q -> q.it ^ "." in
  qualifier ^ r.target.it ^ applied "[" r.indices "]" ^ applied "(" r.arguments ")"

let head (h : head) =
  let formals =
    match h.formals with
    | [] -> ""
    | names -> "(" ^ String.concat ", " (List.map (fun (n : name) -> n.it) names) ^ ")"
  in
  h.declared.it ^ applied "[" h.places "]" ^ formals

(* {1 Features, channels and behaviours} *)

let paths ps = "[" ^ String.concat ", " (List.map path ps) ^ "]"

let feature f =
  match f.it with
  | Named p -> path p
  | Tuple (prefix, vs) -> Option.fold ~none:"" ~some:(fun p -> path p ^ ".") prefix ^ paths vs

let member m = if m.only then "only " ^ feature m.feature else feature m.feature

let surface (c : channel) =
  Printf.sprintf "%s%s, {%s}" (if c.co then "~" else "") c.channel.it
    (String.concat ", " (List.map member c.features))

let angle c = "<" ^ surface c ^ ">"
let push = function None -> "" | Some j -> " push(" ^ expr j ^ ")"

let odds (o : odds) =
  let bare =
    match o.value.it with
    | Number _ | Path { it = [ { indices = []; _ } ]; _ } -> true
    | Binary (Div, { it = Number _; _ }, { it = Number _; _ }) -> true
    | _ -> false
  in
  Printf.sprintf (if bare then " %s %s" else " %s (%s)") o.odds.it (expr o.value)

let weak c j = "omega(" ^ surface c ^ ")" ^ push j.push ^ Option.fold ~none:"" ~some:odds j.odds
let strong cs j = "rho({" ^ String.concat ", " (List.map angle cs) ^ "})" ^ push j
let bond b = Printf.sprintf "<%s, {%s, %s}>" b.bond.it (feature b.first) (feature b.second)

let rec add_behaviour b x =
  match x.it with
  | Sum (l, r) ->
    add_behaviour b l;
    Buffer.add_string b " + ";
    add_term b r
  | _ -> add_term b x

and add_term b x =
  let prefixed text next =
    Buffer.add_string b text;
    Buffer.add_string b ". ";
    add_term b next
  in
  match x.it with
  | Nil -> Buffer.add_string b "nil"
  | Name k -> Buffer.add_string b (reference k)
  | Open (c, next) -> prefixed (angle c) next
  | Weak (c, j, next) -> prefixed (weak c j) next
  | Strong (cs, j, next) -> prefixed (strong cs j) next
  | Delay (t, next) -> prefixed ("eps(" ^ expr t ^ ")") next
  | Sum _ ->
    Buffer.add_char b '(';
    add_behaviour b x;
    Buffer.add_char b ')'

let behaviour x = written add_behaviour x

let prefixes x =
  let rec cut acc x =
    let at = x.at.Scc_base.Span.start in
    let go text next = cut ((at, text ^ ".") :: acc) next in
    match x.it with
    | Open (c, next) -> go (angle c) next
    | Weak (c, j, next) -> go (weak c j) next
    | Strong (cs, j, next) -> go (strong cs j) next
    | Delay (t, next) -> go ("eps(" ^ expr t ^ ")") next
    | Nil | Name _ | Sum _ -> List.rev ((at, written add_term x) :: acc)
  in
  cut [] x

(* {1 Shapes} *)

let quoted s =
  let b = Buffer.create (String.length s + 2) in
  Buffer.add_char b '"';
  String.iter
    (fun c ->
       if c = '"' || c = '\\' then Buffer.add_char b '\\';
       Buffer.add_char b c)
    s;
  Buffer.add_char b '"';
  Buffer.contents b

let face (n : name) vs =
  Printf.sprintf "%s [%s]" n.it (String.concat ", " (List.map (fun (v : name) -> v.it) vs))

let vertex ((n : name), v) = n.it ^ " " ^ closed_vector v

let mending m =
  let length word = Option.fold ~none:"" ~some:(fun e -> word ^ arithmetic e) in
  let word there word = if there then word else "" in
  length " grid " m.grid ^ word m.weld " weld" ^ word m.orient " orient" ^ word m.merge " merge"
  ^ length " snap " m.snap ^ word m.union " union"

let rec solid s =
  match s.it with
  | Template t -> reference t
  | Mesh (file, m) -> "mesh " ^ quoted file.it ^ mending m
  | Scaled (s, v) -> solid s ^ " scaled " ^ vector v
  | Faces (vs, fs) ->
    Printf.sprintf "{ vertices %s faces %s }" (String.concat " " (List.map vertex vs))
      (String.concat " " (List.map (fun (n, vs) -> face n vs) fs))
  | Hull points -> "hull { " ^ String.concat "  " (List.map vertex points) ^ " }"

let rec decomposed s =
  match s.it with
  | Mesh (file, m) -> quoted file.it ^ mending m
  | Scaled (s, v) -> decomposed s ^ " scaled " ^ vector v
  | Template _ | Faces _ | Hull _ -> solid s

let transform t =
  match t.it with
  | Translate v -> "translate " ^ vector v
  | Rotate (w, x, y, z) -> "rotate quaternion " ^ quadruple (w, x, y, z)
  | Scale v -> "scale " ^ vector v
  | Matrix rows -> "matrix (" ^ String.concat ", " (List.map quadruple rows) ^ ")"

let attribute a =
  match a.it with
  | Mass e -> "mass " ^ arithmetic e
  | Velocity v -> "velocity " ^ arithmetic v
  | Spin v -> "spin " ^ arithmetic v
  | Absorb -> "absorb"
  | At ts -> "at " ^ String.concat " * " (List.map transform ts)
