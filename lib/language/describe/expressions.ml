open Scc_base
open Scc_syntax
open Scope

(* As what the bodies, behaviours and templates of a path are looked up. *)
type role = Number | Body | Over | Kind

let diffuse = "diffuse"

let rec expr t c (e : Ast.expr) =
  match e.it with
  | Number _ | True | False -> ()
  | Path p -> path t c Number p
  | Co name -> name_channel t c Asked name
  | Apply (f, es) when c.law && String.equal f.it diffuse -> diffusion t c f es
  | Apply (f, es) -> apply t c f es
  | Apply_in (p, f, es) -> apply_in t c p f es
  | Component (e, axis) ->
    expr t c e;
    component t axis
  | Vector (x, y, z) -> List.iter (expr t c) [ x; y; z ]
  | Neg e | Not e -> expr t c e
  | Binary ((Eq | Ne), ({ it = Apply ({ it = "behaviour"; _ }, _); _ } as a), b) ->
    expr t c a;
    kind t c b
  | Binary ((Eq | Ne), a, ({ it = Apply ({ it = "behaviour"; _ }, _); _ } as b)) ->
    kind t c a;
    expr t c b
  | Binary (_, a, b) ->
    expr t c a;
    expr t c b
  | If (a, b, d) -> List.iter (expr t c) [ a; b; d ]
  | Quantified (q, v, range, body) ->
    let start = match q with Forall | Exists -> e.at.start | Count -> v.at.start in
    quantified t c ~start v range body
  | Temporal (_, b, e) ->
    Option.iter (bound t c) b;
    expr t c e
  | Measured (m, test, o) ->
    measure t c m;
    Option.iter (fun (_, e) -> expr t c e) test;
    outcome t c o
  | Until (_, f, b, g) | Leads_to (f, b, g) ->
    expr t c f;
    Option.iter (bound t c) b;
    expr t c g
  | Event (w, es) -> event t c w es

(* The name of an argument means what the function does. *)
and diffusion t c f es =
  let meaning = first [ (fun () -> word Law diffuse) ] in
  let argument (e : Ast.expr) =
    match e.it with
    | Binary (Eq, { it = Path { it = [ { name; indices = [] } ]; _ }; _ }, value) ->
      known t name meaning;
      expr t c value
    | _ -> expr t c e
  in
  known t f meaning;
  List.iter argument es

and measure t c (m : Ast.expr) =
  match m.it with
  | Path { it = [ { name; indices = [] } ]; _ } -> known t name (first [ (fun () -> word Measure name.it) ])
  | _ -> expr t c m

and outcome t c = function
  | Does e -> expr t c e
  | Goes_until (f, b, g) ->
    expr t c f;
    Option.iter (bound t c) b;
    expr t c g
  | Has_at (e, at) ->
    expr t c e;
    expr t c at

and component t (axis : Ast.name) =
  known t axis (first [ (fun () -> word Component axis.it) ])

and bound t c = function
  | Within e | At_most e -> expr t c e
  | Between (a, b) ->
    expr t c a;
    expr t c b

and bounds t c (b : Ast.bounds) inner =
  expr t c b.low;
  expr t c b.high;
  Option.iter (expr t inner) b.filter

and quantified t c ~start (v : Ast.name) range body =
  let shown stop = Span.make ~file:v.at.file ~start ~stop in
  let d, inner =
    match range with
    | Bodies b ->
      over t c b;
      let what = text "`%s`: a body, any of `%s`" v.it (Printer.expr b) in
      let d = Declared.make Variable v ~shown:(shown b.at.stop) what in
      (d, bind c d)
    | Numbers b ->
      let d = index v ~start b in
      let inner = bind c d in
      bounds t c b inner;
      (d, inner)
  in
  known t v (Declared [ d ]);
  expr t inner body

(* The variable of a loop, or of a quantifier over numbers. *)
and index (v : Ast.name) ~start (b : Ast.bounds) =
  let last = Option.value b.filter ~default:b.high in
  let shown = Span.make ~file:v.at.file ~start ~stop:last.at.stop in
  let range = text "%s..%s" (Printer.expr b.low) (Printer.expr b.high) in
  let those = Option.fold ~none:"" ~some:(fun e -> " for which " ^ Printer.expr e) b.filter in
  Declared.make Index v ~shown (text "`%s`: an integer, any of %s%s" v.it range those)

and over t c (e : Ast.expr) =
  match e.it with
  | Path p -> path t c Over p
  | Apply (f, es) ->
    known t f (first [ among t.all.templates f.it; (fun () -> word Solid f.it) ]);
    List.iter (expr t c) es
  | _ -> expr t c e

(* What a behaviour is compared with. *)
and kind t c (e : Ast.expr) =
  match e.it with
  | Path p -> path t c Kind p
  | Apply (f, es) ->
    known t f (first [ among t.all.behaviours f.it ]);
    List.iter (expr t c) es
  | _ -> expr t c e

and bodies t c es = List.iter (body t c) es
and body t c (e : Ast.expr) = match e.it with Path p -> path t c Body p | _ -> expr t c e

and channel t c (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } -> name_channel t c Asked name
  | _ -> expr t c e

and apply t c (f : Ast.name) es =
  let atom = if c.law then None else word Atom f.it in
  let others () =
    [ among t.all.templates f.it; among t.all.behaviours f.it; (fun () -> word Solid f.it); local c f.it ]
  in
  match (word Function f.it, atom, f.it, es) with
  | Some m, _, _, _ ->
    known t f m;
    List.iter (expr t c) es
  | None, Some m, "bonds", a :: ends ->
    known t f m;
    channel t c a;
    bodies t c ends
  | None, Some m, "offers", [ p; a ] ->
    known t f m;
    body t c p;
    channel t c a
  | None, Some m, _, _ ->
    known t f m;
    bodies t c es
  | None, None, _, _ ->
    known t f (first (others ()));
    List.iter (expr t c) es

and apply_in t c (p : Ast.path) (f : Ast.name) es =
  (match p.it with
   | [ { name = q; indices = [] } ] -> of_module t q f
   | _ ->
     path t c Number p;
     known t f Unknown);
  List.iter (expr t c) es

and of_module t (q : Ast.name) (target : Ast.name) =
  match Declared.find t.all.modules q.it with
  | m :: _ as found ->
    known t q (Declared found);
    known t target (Of_module m)
  | [] ->
    known t q Unknown;
    known t target Unknown

and event t c (w : Ast.name) es =
  known t w (first [ (fun () -> word Event w.it) ]);
  match (w.it, es) with
  | ("bounce" | "absorb" | "hit"), _ | _, [] -> bodies t c es
  | _, a :: ends ->
    channel t c a;
    bodies t c ends

and segments t c (s : Ast.segment list) = List.iter (fun (s : Ast.segment) -> List.iter (expr t c) s.indices) s

and path t c role (p : Ast.path) =
  segments t c p.it;
  match p.it with
  | [] -> ()
  | { name; _ } :: rest -> (
      let imported =
        match (role, Declared.find t.all.modules name.it) with
        | Body, _ | _, [] -> false
        | (Number | Over | Kind), _ :: _ -> true
      in
      match (lexical c name.it, rest) with
      | None, [ { name = target; _ } ] when imported -> of_module t name target
      | None, [ { name = axis; _ } ] when String.equal name.it "momentum" || String.equal name.it "angular" ->
        known t name (first [ (fun () -> word Atom name.it) ]);
        component t axis
      | _, _ ->
        let alone = match rest with [] -> true | _ :: _ -> false in
        let m = first (meanings t c role name.it ~alone) in
        known t name m;
        follow t m rest)

(* What comes after a name and a dot. *)
and follow t m rest =
  match rest with
  | [] -> ()
  | ({ name; _ } : Ast.segment) :: rest ->
    let inside = match m with Declared ds | Alike ds -> ds | _ -> [] in
    let is_value = function { Declared.kind = Value | Parameter | Argument | Index; _ } -> true | _ -> false in
    let axis () = if List.exists is_value inside then word Component name.it else None in
    let m = first [ axis; in_some t inside name.it; alike t name.it; (fun () -> Some Feature) ] in
    known t name m;
    follow t m rest

and meanings t c role name ~alone =
  let local = local c name in
  let variable () =
    match lexical c name with Some ({ kind = Variable; _ } as d) -> Some (Declared [ d ]) | _ -> None
  in
  let bare () =
    let either = if c.law then [ Vocabulary.Law ] else [ Vocabulary.Atom; Law; Setting ] in
    if alone then List.find_map (fun category -> word category name) either else None
  in
  let bodies = among t.all.bodies name
  and behaviours = among t.all.behaviours name
  and templates = among t.all.templates name in
  match role with
  | Body -> [ variable; bodies; local; templates; bare ]
  | Over -> [ templates; bodies; local ]
  | Kind -> [ local; behaviours; bodies ]
  | Number -> [ local; bare; bodies; templates; behaviours; among t.all.values name; alike t name ]
