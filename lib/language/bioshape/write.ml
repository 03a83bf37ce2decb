open Scc_base
open Scc_syntax
open Ast
open Layout

let start (span : Span.t) = if Span.is_none span then -1 else span.start
let last_byte (span : Span.t) = if Span.is_none span then -1 else span.stop - 1

(* {1 Elements} *)

let rec separated sep acc = function
  | [] -> List.rev acc
  | [ d ] -> List.rev (d :: acc)
  | d :: ds -> separated sep (sep :: d :: acc) ds

let separated sep ds = separated sep [] ds

let opening tag attributes =
  let attribute (key, value) = " " ^ key ^ "=" ^ Escaped.attribute value in
  String.concat "" (("<" ^ tag) :: List.map attribute attributes)

let empty ~at tag attributes = text ~at (opening tag attributes ^ "/>")

let filled ~at tag attributes content =
  text ~at (Printf.sprintf "%s>%s</%s>" (opening tag attributes) (Escaped.content content) tag)

let lines ~at ~close between tag attributes children =
  cat
    [ text ~at (opening tag attributes ^ ">"); nest 2 (cat (line :: separated between children)); line;
      closing ~at:close ("</" ^ tag ^ ">") ]

(* With as many of its elements on a line as fit. *)
let short ~at tag attributes = function
  | [] -> empty ~at tag attributes
  | children ->
    let break = fill "" in
    cat
      [ text ~at (opening tag attributes ^ ">"); nest 2 (cat (break :: separated break children));
        text ~at:(-1) ("</" ^ tag ^ ">") ]

let long ~at tag attributes = function
  | [] -> empty ~at tag attributes
  | children -> lines ~at ~close:(-1) line tag attributes children

let optional key f = function None -> [] | Some v -> [ (key, f v) ]
let flag key holds = if holds then [ (key, "true") ] else []
let names key = function [] -> [] | ns -> [ (key, String.concat " " (List.map (fun (n : name) -> n.it) ns)) ]

(* {1 Features and behaviours} *)

let feature (f : feature) = empty ~at:(start f.at) "feature" [ ("name", Text.feature f) ]

let member m =
  empty ~at:(start m.feature.at) "feature" (("name", Text.feature m.feature) :: flag "only" m.only)

let channel ?(more = []) tag (c : channel) =
  short ~at:(start c.span) tag ((("channel", c.channel.it) :: flag "co" c.co) @ more) (List.map member c.features)

let prefix (b : behaviour) =
  match b.it with
  | Open (c, next) -> Some (channel "open" c, next)
  | Weak (c, { push; odds }, next) ->
    let odds = match odds with None -> [] | Some o -> [ ("odds", o.odds.it); ("value", Text.expr o.value) ] in
    Some (channel "weakSplit" ~more:(optional "push" Text.expr push @ odds) c, next)
  | Strong (cs, push, next) ->
    let bonds = List.map (channel "channel") cs in
    Some (long ~at:(start b.at) "strongSplit" (optional "push" Text.expr push) bonds, next)
  | Delay (t, next) -> Some (empty ~at:(start b.at) "delay" [ ("time", Text.expr t) ], next)
  | Nil | Name _ | Sum _ -> None

let summands b =
  let rec spine acc b = match b.it with Sum (l, r) -> spine (r :: acc) l | _ -> b :: acc in
  spine [] b

let rec behaviour (b : behaviour) =
  let rec go acc (b : behaviour) =
    match (prefix b, b.it) with
    | Some (element, next), _ -> go (element :: acc) next
    | None, Name r -> List.rev (empty ~at:(start b.at) "call" [ ("name", Text.reference r) ] :: acc)
    | None, Sum _ -> List.rev (long ~at:(start b.at) "choice" [] (List.map branch (summands b)) :: acc)
    | None, _ -> List.rev (empty ~at:(start b.at) "nil" [] :: acc)
  in
  go [] b

and branch b = long ~at:(start b.at) "branch" [] (behaviour b)

(* {1 Shapes and where they are} *)

let point (v : vector) =
  match v.it with
  | Vector (x, y, z) -> [ ("x", Text.expr x); ("y", Text.expr y); ("z", Text.expr z) ]
  | _ -> [ ("point", Text.expr v) ]

let vertex ((n : name), v) = empty ~at:(start n.at) "vertex" (("name", n.it) :: point v)
let face ((n : name), vs) = empty ~at:(start n.at) "face" (("name", n.it) :: names "vertices" vs)

let solid s =
  let rec go acc (s : solid) =
    let at = start s.at in
    match s.it with
    | Scaled (s, v) -> go (empty ~at:(start v.at) "scaled" [ ("by", Text.expr v) ] :: acc) s
    | Template r -> empty ~at "template" [ ("name", Text.reference r) ] :: acc
    | Mesh (file, m) ->
      let word key there = if there then [ (key, "true") ] else [] in
      let words = word "weld" m.weld @ word "orient" m.orient @ word "merge" m.merge in
      let lengths key = optional key Text.expr in
      let last = lengths "snap" m.snap @ word "union" m.union in
      empty ~at "mesh" (("file", file.it) :: lengths "grid" m.grid @ words @ last) :: acc
    | Faces (vs, fs) -> long ~at "indexedFaceSet" [] (List.append (List.map vertex vs) (List.map face fs)) :: acc
    | Hull vs -> long ~at "hull" [] (List.map vertex vs) :: acc
  in
  go [] s

let transform (t : transform) =
  let empty = empty ~at:(start t.at) in
  let quadruple (w, x, y, z) =
    [ ("w", Text.expr w); ("x", Text.expr x); ("y", Text.expr y); ("z", Text.expr z) ]
  in
  match t.it with
  | Translate v -> empty "translate" [ ("by", Text.expr v) ]
  | Rotate (w, x, y, z) -> empty "rotate" (quadruple (w, x, y, z))
  | Scale v -> empty "scale" [ ("by", Text.expr v) ]
  | Matrix rows ->
    let row (a, b, c, d) =
      text ~at:(-1)
        (opening "row" [ ("a", Text.expr a); ("b", Text.expr b); ("c", Text.expr c); ("d", Text.expr d) ] ^ "/>")
    in
    long ~at:(start t.at) "matrix" [] (List.map row rows)

let attribute (a : attribute) =
  let value tag e = empty ~at:(start a.at) tag [ ("value", Text.expr e) ] in
  match a.it with
  | Mass e -> value "mass" e
  | Velocity v -> value "velocity" v
  | Spin v -> value "spin" v
  | Absorb -> empty ~at:(start a.at) "absorb" []
  | At ts -> short ~at:(start a.at) "at" [] (List.map transform ts)

(* {1 Processes} *)

let leaf (l : leaf) =
  let box (b : behaviour) = long ~at:(start b.at) "behaviour" [] (behaviour b) in
  long ~at:(start l.leaf_span) "leaf"
    (optional "label" Text.segment l.label)
    (List.concat [ solid l.solid; List.map attribute l.attributes; List.map box (Option.to_list l.behaviour) ])

let bond b =
  short ~at:(start b.bond_span) "bond" [ ("channel", b.bond.it) ] [ feature b.first; feature b.second ]

let chain span tag name first rest =
  let link (b, l) = [ bond b; leaf l ] in
  lines ~at:(start span) ~close:(last_byte span) line tag
    [ ("name", Text.segment name) ]
    (leaf first :: List.concat (List.map link rest))

(* {1 Declarations} *)

let interval { low; high; filter } =
  [ ("from", Text.expr low); ("to", Text.expr high) ] @ optional "if" Text.expr filter

let range (r : range) = empty ~at:(start r.index.at) "range" (("index", r.index.it) :: interval r.bounds)

let law at (l : law) =
  match l.it with
  | Inertial -> empty ~at "inertial" []
  | Expression (v, spin) ->
    empty ~at:(start v.at) "velocity" (("value", Text.expr v) :: optional "spin" Text.expr spin)
  | Choose kicks ->
    let kick (k : kick) =
      short ~at:(start k.velocity.at) "kick"
        (("velocity", Text.expr k.velocity)
         :: (optional "spin" Text.expr k.spin @ optional "weight" Text.expr k.weight))
        (List.map range k.over)
    in
    long ~at "choose" [] (List.map kick kicks)

let definition ((n : name), e) = empty ~at:(start n.at) "where" [ ("name", n.it); ("value", Text.expr e) ]

let import ~at (i : import) =
  let used ((n : name), other) =
    empty ~at:(start n.at) "use" (("name", n.it) :: optional "as" (fun (m : name) -> m.it) other)
  in
  let from = ((if i.library then "library" else "file"), i.from.it) in
  match i.names with
  | Qualified q -> empty ~at "import" (from :: optional "as" (fun (q : name) -> q.it) q)
  | Chosen ns -> short ~at "import" [ from ] (List.map used ns)

let part p =
  long ~at:(start p.part_span) "part"
    [ ("name", p.part.it) ]
    (solid p.part_solid @ List.map attribute p.part_attributes)

let glue g = short ~at:(start g.glue_span) "glue" [] [ feature g.glue_first; feature g.glue_second ]

let limits low high =
  [
    ((if low.included then "from" else "above"), Text.expr low.value);
    ((if high.included then "to" else "below"), Text.expr high.value);
  ]

let pace = function Shared -> [] | Local -> [ ("pace", "local") ] | Steady -> [ ("pace", "steady") ]
let declared (h : head) = ("name", Text.head { h with formals = [] }) :: names "parameters" h.formals

let rec item (i : item) =
  let at = start i.at in
  let value tag e = empty ~at tag [ ("value", e) ] in
  let block tag attributes children = lines ~at ~close:(last_byte i.at) line tag attributes children in
  match i.it with
  | Model n -> empty ~at "model" [ ("name", n.it) ]
  | Import i -> import ~at i
  | Param (n, e) -> empty ~at "parameter" [ ("name", n.it); ("value", Text.expr e) ]
  | Param_in (n, low, high) -> empty ~at "parameter" (("name", n.it) :: limits low high)
  | Timestep (e, p) -> empty ~at "timestep" (("value", Text.expr e) :: pace p)
  | Split_step e -> value "splitStep" (Text.expr e)
  | Dynamics n -> value "dynamics" n.it
  | Collisions n -> value "collisions" n.it
  | Binding n -> value "binding" n.it
  | Bonds n -> value "bonds" n.it
  | Blocked n -> value "blocked" n.it
  | Resolution e -> value "resolution" (Text.expr e)
  | Round (n, e) -> empty ~at "round" [ ("of", n.it); ("to", Text.expr e) ]
  | Shape (h, s, ds) -> block "shape" (declared h) (solid s @ List.map definition ds)
  | Compound (h, parts, glues, ds) ->
    long ~at "compound" (declared h)
      (List.concat [ List.map part parts; List.map glue glues; List.map definition ds ])
  | Decomposed (h, s, attributes, ds) ->
    block "decomposed" (declared h)
      (List.concat [ solid s; List.map attribute attributes; List.map definition ds ])
  | Behaviour (h, on, b, ds) ->
    block "behaviour" (declared h @ optional "on" Text.reference on)
      (List.append (behaviour b) (List.map definition ds))
  | Process (n, l, rest) -> chain i.at "process" n l rest
  | Fixed (n, l, rest) -> chain i.at "fixed" n l rest
  | Bond b -> bond b
  | For (over, body) ->
    lines ~at ~close:(last_byte i.at) paragraph "for" [] (List.append (List.map range over) (List.map item body))
  | Network ps ->
    let member (p : path) = empty ~at:(start p.at) "member" [ ("name", Text.path p) ] in
    long ~at "network" [] (List.map member ps)
  | Motion (p, l) -> short ~at "motion" (optional "of" Text.path p) [ law (start l.at) l ]
  | Let (n, e) -> empty ~at "let" [ ("name", n.it); ("value", Text.expr e) ]
  | Check (n, e) -> filled ~at "check" [ ("name", n.it) ] (Text.expr e)

(* {1 Documents} *)

(* What XML has no character for: in the names of files alone, since all other text of a model is ASCII. *)
let rec unwritable (i : item) =
  let of_solid (s : solid) =
    let rec file (s : solid) = match s.it with Scaled (s, _) -> file s | Mesh (f, _) -> [ f ] | _ -> [] in
    file s
  in
  let leaves l rest = l :: List.map snd rest in
  match i.it with
  | Import { from; _ } -> [ from ]
  | Shape (_, s, _) -> of_solid s
  | Compound (_, parts, _, _) -> List.concat_map (fun p -> of_solid p.part_solid) parts
  | Process (_, l, rest) | Fixed (_, l, rest) ->
    List.concat_map (fun (l : leaf) -> of_solid l.solid) (leaves l rest)
  | For (_, body) -> List.concat_map unwritable body
  | _ -> []

let refused (file : string loc) =
  if Escaped.is_text file.it then None
  else Some (Diag.error Code.xml_text file.at "this name of a file holds a character that XML does not have")

let model ?(trivia = []) items =
  match List.filter_map refused (List.concat_map unwritable items) with
  | _ :: _ as errors -> Error errors
  | [] ->
    let root = opening "bioshape" [ ("xmlns", Namespace.uri) ] ^ ">" in
    let body =
      cat
        [ text ~at:(-1) "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"; line; text ~at:(-1) root;
          nest 2 (cat (paragraph :: separated paragraph (List.map item items))); line;
          closing ~at:max_int "</bioshape>" ]
    in
    Ok (render (List.map Comment.written trivia) body)
