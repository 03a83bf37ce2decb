(* The real parser, for the tests of the grammars of editors: one text after another, each after a line with its
   number of bytes, on standard input. For each a line of JSON on standard output has its codes (none if it is
   accepted), its tokens and comments, and the nodes of its tree, each as its kind with its first byte and the byte
   after its last one.

   reference.exe words writes the words of the language instead, one a line. *)

open Scc_base
open Scc_syntax

type node = { kind : string; start : int; stop : int }

(* {1 Tokens} *)

let token (text : string) (t : Tokens.token) =
  let first = text.[t.start] in
  let kind =
    match t.token with
    | NAME _ -> "name"
    | BARRED _ -> "barred_name"
    | STRING _ -> "string"
    | NUMBER _ -> "number"
    | LABEL_BRACKET -> "label"
    | OMEGA | RHO | EPS -> "word"
    | _ -> if (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z') then "word" else "mark"
  in
  { kind; start = t.start; stop = t.stop }

let tokens source =
  let t = Tokens.read source in
  let comment (c : Trivia.t) =
    match c.kind with
    | Blank -> None
    | Line -> Some { kind = "line_comment"; start = c.start; stop = c.stop }
    | Block -> Some { kind = "block_comment"; start = c.start; stop = c.stop }
  in
  let last = Array.length t.tokens - 1 in
  List.map (token (Source.text source)) (Array.to_list (Array.sub t.tokens 0 last))
  @ List.filter_map comment t.trivia

(* {1 Nodes}, of the names that the grammar for tree-sitter gives them *)

let found = ref []
let note kind (at : Span.t) = found := { kind; start = at.start; stop = at.stop } :: !found
let located kind (x : 'a Ast.loc) = note kind x.at
let name (n : Ast.name) = located "name" n
let option f = function Some x -> f x | None -> ()

let rec segment (s : Ast.segment) =
  name s.name;
  List.iter expr s.indices

and path (p : Ast.path) =
  located "path" p;
  List.iter segment p.it

and bounds (b : Ast.bounds) =
  expr b.low;
  expr b.high;
  option expr b.filter

and bound : Ast.bound -> unit = function
  | Within e | At_most e -> expr e
  | Between (a, b) -> List.iter expr [ a; b ]

and outcome : Ast.outcome -> unit = function
  | Does e -> expr e
  | Goes_until (f, b, g) ->
    option bound b;
    List.iter expr [ f; g ]
  | Has_at (e, t) -> List.iter expr [ e; t ]

and expr (e : Ast.expr) =
  let kind : string =
    match e.it with
    | Number _ -> "number"
    | True | False -> "boolean"
    | Path _ -> "path"
    | Co _ -> "co_name"
    | Apply _ -> "call"
    | Apply_in _ -> "qualified_call"
    | Component _ -> "component"
    | Vector _ -> "vector"
    | Neg _ -> "negation"
    | Not _ -> "not"
    | Binary _ -> "binary"
    | If _ -> "conditional"
    | Quantified (Count, _, _, _) -> "count"
    | Quantified ((Forall | Exists), _, _, _) -> "quantified"
    | Temporal _ -> "temporal"
    | Until _ -> "until"
    | Measured _ -> "measured"
    | Leads_to _ -> "leads_to"
    | Event _ -> "event"
  in
  (match e.it with Path _ -> () | _ -> located kind e);
  operands e

and operands (e : Ast.expr) =
  match e.it with
  | Number _ | True | False -> ()
  | Path p -> path p
  | Co n -> name n
  | Apply (f, es) | Event (f, es) ->
    name f;
    List.iter expr es
  | Apply_in (p, f, es) ->
    path p;
    name f;
    List.iter expr es
  | Component (e, n) ->
    expr e;
    name n
  | Vector (x, y, z) | If (x, y, z) -> List.iter expr [ x; y; z ]
  | Neg e | Not e -> expr e
  | Binary (_, l, r) -> List.iter expr [ l; r ]
  | Quantified (_, n, over, e) ->
    name n;
    (match over with Bodies b -> expr b | Numbers b -> bounds b);
    expr e
  | Temporal (_, b, e) ->
    option bound b;
    expr e
  | Until (_, f, b, g) | Leads_to (f, b, g) ->
    option bound b;
    List.iter expr [ f; g ]
  | Measured (m, limit, o) ->
    expr m;
    option (fun (_, e) -> expr e) limit;
    outcome o

let feature (f : Ast.feature) =
  located "feature" f;
  match f.it with
  | Named p -> List.iter segment p.it
  | Tuple (p, vs) ->
    option (fun (p : Ast.path) -> List.iter segment p.it) p;
    List.iter path vs

let reference (r : Ast.reference) =
  option name r.qualifier;
  name r.target;
  List.iter expr (r.indices @ r.arguments)

let channel kind (c : Ast.channel) =
  note kind c.span;
  name c.channel;
  List.iter (fun (m : Ast.member) -> feature m.feature) c.features

let odds (o : Ast.odds) =
  name o.odds;
  expr o.value

let rec behaviour (b : Ast.behaviour) =
  match b.it with
  | Nil -> located "nil" b
  | Open (c, rest) ->
    located "opening" b;
    channel "channel" c;
    behaviour rest
  | Weak (c, l, rest) ->
    located "weak_split" b;
    channel "weak_channel" c;
    option expr l.push;
    option odds l.odds;
    behaviour rest
  | Strong (cs, push, rest) ->
    located "strong_split" b;
    List.iter (channel "channel") cs;
    option expr push;
    behaviour rest
  | Delay (t, rest) ->
    located "delay" b;
    expr t;
    behaviour rest
  | Sum (l, r) ->
    located "sum" b;
    List.iter behaviour [ l; r ]
  | Name r ->
    located "behaviour_name" b;
    reference r

let vertices = List.iter (fun (n, v) -> name n; expr v)

let mesh file (m : Ast.mending) =
  located "string" file;
  option expr m.grid;
  option expr m.snap

let rec solid (s : Ast.solid) =
  match s.it with
  | Template r ->
    located "template_name" s;
    reference r
  | Scaled (t, v) ->
    located "scaled" s;
    solid t;
    expr v
  | Mesh (file, m) ->
    located "mesh" s;
    mesh file m
  | Faces (vs, fs) ->
    located "template" s;
    vertices vs;
    List.iter (fun (n, ns) -> List.iter name (n :: ns)) fs
  | Hull vs ->
    located "hull" s;
    vertices vs

let transform (t : Ast.transform) =
  match t.it with
  | Translate v ->
    located "translate" t;
    expr v
  | Rotate (w, x, y, z) ->
    located "rotate" t;
    List.iter expr [ w; x; y; z ]
  | Scale v ->
    located "scale" t;
    expr v
  | Matrix rows ->
    located "matrix" t;
    List.iter (fun (a, b, c, d) -> List.iter expr [ a; b; c; d ]) rows

let attribute (a : Ast.attribute) =
  match a.it with
  | Mass e ->
    located "mass" a;
    expr e
  | Velocity e ->
    located "velocity" a;
    expr e
  | Spin e ->
    located "spin" a;
    expr e
  | Absorb -> located "absorb" a
  | At ts ->
    located "placement" a;
    List.iter transform ts

let bond (b : Ast.bond) =
  note "bond" b.bond_span;
  name b.bond;
  List.iter feature [ b.first; b.second ]

let part (p : Ast.part) =
  note "part" p.part_span;
  name p.part;
  solid p.part_solid;
  List.iter attribute p.part_attributes

let glue (g : Ast.glue) =
  note "glue" g.glue_span;
  List.iter feature [ g.glue_first; g.glue_second ]

let leaf (l : Ast.leaf) =
  note "leaf" l.leaf_span;
  option segment l.label;
  solid l.solid;
  List.iter attribute l.attributes;
  option behaviour l.behaviour

let chain first rest =
  leaf first;
  List.iter (fun (b, l) -> bond b; leaf l) rest

let range (r : Ast.range) =
  name r.index;
  bounds r.bounds

let kick (k : Ast.kick) =
  List.iter range k.over;
  expr k.velocity;
  option expr k.spin;
  option expr k.weight

let law (l : Ast.law) =
  match l.it with
  | Inertial -> located "inertial" l
  | Expression (v, s) ->
    located "law" l;
    expr v;
    option expr s
  | Choose kicks ->
    located "choose" l;
    List.iter kick kicks

let definitions = List.iter (fun (n, e) -> name n; expr e)

let head (h : Ast.head) =
  name h.declared;
  List.iter expr h.places;
  List.iter name h.formals

let import (i : Ast.import) =
  located (if i.library then "name" else "string") i.from;
  match i.names with
  | Qualified n -> option name n
  | Chosen ns -> List.iter (fun (n, m) -> name n; option name m) ns

let rec item (i : Ast.item) =
  let is kind = located (kind ^ "_declaration") i in
  match i.it with
  | Model n -> is "model"; name n
  | Import m -> is "import"; import m
  | Param (n, e) -> is "param"; name n; expr e
  | Param_in (n, low, high) -> is "param"; name n; List.iter expr [ low.value; high.value ]
  | Timestep (e, _) -> is "timestep"; expr e
  | Split_step e -> is "split_step"; expr e
  | Dynamics n | Collisions n | Binding n | Bonds n | Blocked n -> is "setting"; name n
  | Resolution e -> is "resolution"; expr e
  | Round (n, e) -> is "round"; name n; expr e
  | Shape (h, s, ds) -> is "shape"; head h; solid s; definitions ds
  | Compound (h, parts, glues, ds) ->
    is "compound"; head h; List.iter part parts; List.iter glue glues; definitions ds
  | Decomposed (h, s, attributes, ds) ->
    is "compound"; head h; solid s; List.iter attribute attributes; definitions ds
  | Behaviour (h, on, b, ds) -> is "behaviour"; head h; option reference on; behaviour b; definitions ds
  | Process (s, first, rest) -> is "process"; segment s; chain first rest
  | Fixed (s, first, rest) -> is "fixed"; segment s; chain first rest
  | Bond b -> is "bond"; bond b
  | For (ranges, items) -> is "for"; List.iter range ranges; List.iter item items
  | Network ps -> is "network"; List.iter path ps
  | Motion (p, l) -> is "motion"; option path p; law l
  | Let (n, e) -> is "let"; name n; expr e
  | Check (n, e) -> is "check"; name n; expr e

(* {1 Answers} *)

let node { kind; start; stop } = `List [ `String kind; `Int start; `Int stop ]

let answer text =
  let source = Source.make ~name:"text" text in
  found := [];
  let codes =
    match Parse.parse source with
    | Ok model -> List.iter item model; []
    | Error errors -> List.sort_uniq String.compare (List.map (fun (d : Diag.t) -> d.code) errors)
  in
  `Assoc
    [
      ("codes", `List (List.map (fun c -> `String c) codes));
      ("tokens", `List (List.map node (tokens source)));
      ("nodes", `List (List.map node !found));
    ]

let rec answers () =
  match input_line stdin with
  | exception End_of_file -> ()
  | size ->
    Yojson.Safe.to_channel stdout (answer (really_input_string stdin (int_of_string size)));
    print_newline ();
    answers ()

let () =
  match Sys.argv with
  | [| _; "words" |] -> List.iter (fun (word, _) -> print_endline word) Lexer.words
  | _ -> answers ()
