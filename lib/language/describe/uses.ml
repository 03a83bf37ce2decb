open Scc_base
open Scc_syntax
open Scope
open Expressions

(* {1 Solids} *)

let template t c (r : Ast.reference) =
  (match r.qualifier with
   | Some q -> of_module t q r.target
   | None ->
     known t r.target
       (first
          [
            among t.all.templates r.target.it;
            (fun () -> word Solid r.target.it);
            local c r.target.it;
          ]));
  List.iter (expr t c) r.indices;
  List.iter (expr t c) r.arguments

let rec solid t c (s : Ast.solid) =
  match s.it with
  | Template r -> template t c r
  | Scaled (s, v) ->
    solid t c s;
    expr t c v
  | Mesh (_, m) ->
    Option.iter (expr t c) m.grid;
    Option.iter (expr t c) m.snap
  | Hull points -> List.iter (vertex t c) points
  | Faces (vertices, faces) ->
    List.iter (vertex t c) vertices;
    List.iter (face t c) faces

and vertex t c ((n : Ast.name), v) =
  known t n (first [ in_some t c.within n.it ]);
  expr t c v

and face t c ((n : Ast.name), corners) =
  known t n (first [ in_some t c.within n.it ]);
  List.iter (fun (v : Ast.name) -> known t v (first [ in_some t c.within v.it ])) corners

let transform t c (tr : Ast.transform) =
  match tr.it with
  | Translate v | Scale v -> expr t c v
  | Rotate (w, x, y, z) -> List.iter (expr t c) [ w; x; y; z ]
  | Matrix rows -> List.iter (fun (a, b, d, e) -> List.iter (expr t c) [ a; b; d; e ]) rows

let attribute t c (a : Ast.attribute) =
  match a.it with
  | Mass e | Velocity e | Spin e -> expr t c e
  | Absorb -> ()
  | At ts -> List.iter (transform t c) ts

(* {1 Features and behaviours} *)

let feature_path t c (p : Ast.path) =
  segments t c p.it;
  match p.it with
  | [] -> ()
  | { name; _ } :: rest ->
    let m = feature_name t c name.it ~alone:(match rest with [] -> true | _ :: _ -> false) in
    (match m with
     | Declared ({ kind = Argument; _ } as d :: _) -> Hashtbl.add t.arguments d.name.at.start As_feature
     | _ -> ());
    known t name m;
    follow t m rest

let feature t c (f : Ast.feature) =
  match f.it with
  | Named p -> feature_path t c p
  | Tuple (prefix, corners) ->
    Option.iter (feature_path t c) prefix;
    let last (p : Ast.path) =
      match List.rev p.it with s :: _ -> Hashtbl.find_opt t.uses s.name.at.start | [] -> None
    in
    let within =
      match Option.bind prefix last with
      | Some { meaning = (lazy (Declared ds | Alike ds)); _ } -> ds
      | Some _ | None -> c.within
    in
    List.iter (feature_path t { c with within }) corners

let channel_of t c how (ch : Ast.channel) =
  name_channel t c how ch.channel;
  List.iter (fun (m : Ast.member) -> feature t c m.feature) ch.features

let opened (ch : Ast.channel) = if ch.co then As_co_name else As_name

(* What becomes of the argument of a behaviour is told by what its argument is used for there. *)
let use_of t k i =
  let seen = Hashtbl.create 8 in
  let of_formal (a : Ast.name) = Hashtbl.find_all t.arguments a.at.start in
  let rec at_place (k : Ast.name) i =
    let of_family formals = Option.fold ~none:[] ~some:of_formal (List.nth_opt formals i) in
    List.find_map through (List.concat_map of_family (Hashtbl.find_all t.families k.it))
  and through = function
    | To (k, i) when Hashtbl.mem seen (k.it, i) -> None
    | To (k, i) ->
      Hashtbl.add seen (k.it, i) ();
      at_place k i
    | (As_channel | As_feature | As_behaviour) as direct -> Some direct
  in
  at_place k i

let passed t c (k : Ast.name) i (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } -> (
      match lexical c name.it with
      | Some d ->
        if Option.is_some (argument c name.it) then Hashtbl.add t.arguments d.name.at.start (To (k, i));
        known t name (Declared [ d ])
      | None ->
        let as_feature () = feature_name t c name.it ~alone:true in
        let feature () = Some (as_feature ()) in
        let channel () = if Hashtbl.mem t.channels name.it then Some Channel else None in
        let meaning () =
          match use_of t k i with
          | Some As_channel -> Channel
          | Some As_feature -> as_feature ()
          | Some (As_behaviour | To _) | None ->
            first [ among t.all.behaviours name.it; among t.all.values name.it; channel; feature ]
        in
        let meaning = Lazy.from_fun meaning in
        t.passed <- (name.it, { how = Passed; owner = c.owner; at = name.at }, meaning) :: t.passed;
        add t name meaning)
  | _ -> expr t c e

let reference t c (r : Ast.reference) =
  (match (r.qualifier, argument c r.target.it) with
   | Some q, _ -> of_module t q r.target
   | None, Some d ->
     Hashtbl.add t.arguments d.name.at.start As_behaviour;
     known t r.target (Declared [ d ])
   | None, None -> known t r.target (first [ among t.all.behaviours r.target.it ]));
  List.iter (expr t c) r.indices;
  List.iteri (passed t c r.target) r.arguments

let setting t (name : Ast.name) = known t name (first [ (fun () -> word Setting name.it) ])

let rec behaviour t c (b : Ast.behaviour) =
  match b.it with
  | Nil -> ()
  | Open (ch, b) ->
    channel_of t c (opened ch) ch;
    behaviour t c b
  | Weak (ch, { push; odds }, b) ->
    channel_of t c Weak ch;
    Option.iter (expr t c) push;
    Option.iter
      (fun ({ odds; value } : Ast.odds) ->
         setting t odds;
         expr t c value)
      odds;
    behaviour t c b
  | Strong (chs, push, b) ->
    List.iter (channel_of t c Strong) chs;
    Option.iter (expr t c) push;
    behaviour t c b
  | Delay (e, b) ->
    expr t c e;
    behaviour t c b
  | Sum (a, b) ->
    behaviour t c a;
    behaviour t c b
  | Name r -> reference t c r

let bond t c (b : Ast.bond) =
  name_channel t c Bond b.bond;
  feature t { c with within = [] } b.first;
  feature t { c with within = [] } b.second

(* {1 Items} *)

let declare t (name : Ast.name) =
  let found = Declared.at t.all name in
  known t name (Declared found);
  found

(* The arguments of a family, for its declaration alone. An index is one where it stands for nothing else. *)
let head t c (h : Ast.head) shown =
  let called = Printer.head h in
  let argument c (n : Ast.name) =
    let d = Declared.make Argument n ~shown (text "`%s`: an argument of `%s`" n.it called) in
    known t n (Declared [ d ]);
    bind c d
  in
  let place c (e : Ast.expr) =
    match e.it with
    | Path { it = [ { name; indices = [] } ]; _ } when Option.is_none (lexical c name.it) -> argument c name
    | _ ->
      expr t c e;
      c
  in
  List.fold_left argument (List.fold_left place c h.places) h.formals

let definitions t c (h : Ast.head) ds =
  let one c ((n : Ast.name), (e : Ast.expr)) =
    expr t c e;
    let shown = Span.merge n.at e.at in
    let d = Declared.make Value n ~shown (text "value `%s`, for `%s` alone" n.it (Printer.head h)) in
    known t n (Declared [ d ]);
    bind c d
  in
  List.fold_left one c ds

let leaf t c of_process (l : Ast.leaf) =
  let segment (s : Ast.segment) =
    List.iter (expr t c) s.indices;
    declare t s.name
  in
  let within = Option.fold ~none:of_process ~some:segment l.label in
  let owner = Option.fold ~none:c.owner ~some:(fun (s : Ast.segment) -> s.name.it) l.label in
  solid t c l.solid;
  List.iter (attribute t c) l.attributes;
  Option.iter (behaviour t { c with within; owner }) l.behaviour

let process t c (s : Ast.segment) one rest =
  List.iter (expr t c) s.indices;
  let d = declare t s.name in
  let c = { c with owner = s.name.it } in
  leaf t c d one;
  let next (b, l) =
    bond t c b;
    leaf t c d l
  in
  List.iter next rest

(* What is within, where its variable is known. *)
let range t c (r : Ast.range) =
  let d = index r.index ~start:r.index.at.start r.bounds in
  let inner = bind c d in
  known t r.index (Declared [ d ]);
  bounds t c r.bounds inner;
  inner

let law t c (l : Ast.law) =
  let c = { c with law = true } in
  match l.it with
  | Inertial -> ()
  | Expression (v, spin) ->
    expr t c v;
    Option.iter (expr t c) spin
  | Choose kicks ->
    let kick (k : Ast.kick) =
      let c = List.fold_left (range t) c k.over in
      expr t c k.velocity;
      Option.iter (expr t c) k.spin;
      Option.iter (expr t c) k.weight
    in
    List.iter kick kicks

let compound t c (h : Ast.head) parts glues ds shown =
  let within = declare t h.declared in
  let c = definitions t (head t { c with within } h shown) h ds in
  let part (p : Ast.part) =
    known t p.part (first [ in_some t within p.part.it ]);
    solid t c p.part_solid;
    List.iter (attribute t c) p.part_attributes
  in
  let glue (g : Ast.glue) =
    feature t c g.glue_first;
    feature t c g.glue_second
  in
  List.iter part parts;
  List.iter glue glues

let import t (i : Ast.import) shown =
  known t i.from (Declared [ Declared.of_import i shown ]);
  match i.names with
  | Qualified alias -> Option.iter (fun n -> ignore (declare t n)) alias
  | Chosen names ->
    let one ((n : Ast.name), alias) =
      let d = declare t (Option.value alias ~default:n) in
      known t n (Declared d)
    in
    List.iter one names

let value t c name = List.fold_left bind c (declare t name)

let rec item t c (i : Ast.item) =
  match i.it with
  | Param (n, e) | Let (n, e) ->
    expr t { c with owner = n.it } e;
    value t c n
  | Param_in (n, low, high) ->
    expr t c low.value;
    expr t c high.value;
    value t c n
  | _ ->
    plain t c i;
    c

and plain t c (i : Ast.item) =
  match i.it with
  | Model n -> ignore (declare t n)
  | Import im -> import t im i.at
  | Timestep (e, _) | Split_step e | Resolution e -> expr t c e
  | Dynamics n | Collisions n | Binding n | Bonds n | Blocked n -> setting t n
  | Round (n, e) ->
    setting t n;
    expr t c e
  | Shape (h, s, ds) ->
    let within = declare t h.declared in
    solid t (definitions t (head t { c with within } h i.at) h ds) s
  | Compound (h, parts, glues, ds) -> compound t c h parts glues ds i.at
  | Decomposed (h, s, attributes, ds) ->
    let within = declare t h.declared in
    let c = definitions t (head t { c with within } h i.at) h ds in
    solid t c s;
    List.iter (attribute t c) attributes
  | Behaviour (h, on, b, ds) ->
    ignore (declare t h.declared);
    Hashtbl.add t.families h.declared.it h.formals;
    Option.iter (template t c) on;
    let templates (r : Ast.reference) =
      match r.qualifier with
      | None -> Declared.find t.all.templates r.target.it
      | Some _ -> []
    in
    let wearer solid = Declared.make Leaf h.declared ~solid "" in
    let of_wearers () = List.map wearer (Wearers.solids t.wearers h.declared.it) in
    let within = match on with Some r -> templates r | None -> of_wearers () in
    behaviour t (definitions t (head t { c with within; owner = h.declared.it } h i.at) h ds) b
  | Process (s, one, rest) | Fixed (s, one, rest) -> process t c s one rest
  | Bond b -> bond t c b
  | For (ranges, items) ->
    ignore (List.fold_left (item t) (List.fold_left (range t) c ranges) items)
  | Network paths -> List.iter (path t c Body) paths
  | Motion (of_whom, l) ->
    Option.iter (path t c Body) of_whom;
    law t c l
  | Check (n, e) ->
    ignore (declare t n);
    expr t { c with owner = n.it } e
  | Param _ | Param_in _ | Let _ -> ()

(* {1 A text} *)

type t = Scope.t

let of_model all (model : Ast.model) =
  let t = make all (Wearers.of_model model) in
  ignore (List.fold_left (item t) nowhere model);
  t

let at t offset = Hashtbl.find_opt t.uses offset

let channel t name =
  let passed (n, use, meaning) =
    match meaning with lazy Channel when String.equal n name -> Some use | _ -> None
  in
  let all = Hashtbl.find_all t.channels name @ List.filter_map passed t.passed in
  List.sort (fun a b -> Int.compare a.at.Span.start b.at.Span.start) all
