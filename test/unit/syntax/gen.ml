open Scc_syntax.Ast
open QCheck2.Gen

let ( let* ) = bind
let ( and* ) = pair
let loc it = { it; at = Scc_base.Span.none }
let located g = map loc g
let few g = list_size (int_range 0 3) g
let some g = list_size (int_range 1 3) g

let name =
  located
    (oneofl
       [
         "a"; "b"; "p"; "q"; "x'"; "x_1"; "Cube"; "bond"; "mass"; "event"; "momentum"; "round"; "resolution";
         "dynamics"; "U2"; "Ax"; "omega_"; "A"; "E"; "F"; "G"; "U"; "X"; "mod";
         "hull"; "as"; "where";
       ])

let number =
  let decimal m k = Q.div (Q.of_int m) (Q.of_bigint (Z.pow (Z.of_int 10) k)) in
  oneof
    [
      map Q.of_int (int_range 0 12);
      map2 decimal (int_range 0 9999) (int_range 0 5);
      map (fun k -> Q.of_bigint (Z.pow (Z.of_int 10) k)) (int_range 0 60);
      map (decimal 125) (int_range 20 60);
    ]

let segment_of expr =
  let* n = name in
  let* indices = frequency [ (4, return []); (1, some expr) ] in
  return { name = n; indices }

let path_of expr = located (list_size (frequencyl [ (4, 1); (2, 2); (1, 3) ]) (segment_of expr))

let bound_of expr =
  oneof [ map (fun t -> At_most t) expr; map2 (fun a b -> Between (a, b)) expr expr ]

let quantifier = oneofl [ A; E ]

let binary =
  oneofl [ Add; Sub; Mul; Div; Mod; Lt; Le; Gt; Ge; Eq; Ne; And; Or; Implies ]

let temporal_of expr =
  let* body = expr in
  oneof
    [
      (let* t = oneofl [ Possibly; Always; Eventually ] in
       let* b = opt (oneof [ map (fun t -> Within t) expr; bound_of expr ]) in
       return (Temporal (t, b, body)));
      (let* q = quantifier in
       let* t = oneofl [ Finally q; Globally q ] in
       let* b = opt (bound_of expr) in
       return (Temporal (t, b, body)));
      map (fun q -> Temporal (Next q, None, body)) quantifier;
      (let* q = quantifier in
       let* b = opt (bound_of expr) in
       let* f = expr in
       return (Until (q, f, b, body)));
      (let* b = opt (oneof [ map (fun t -> Within t) expr; bound_of expr ]) in
       let* f = expr in
       return (Leads_to (f, b, body)));
    ]

let leaf_expr path =
  oneof
    [
      map (fun q -> Number q) number; return True; return False; map (fun p -> Path p) path;
      map (fun n -> Co n) name;
    ]

(* A division by a literal zero is refused where it is read. *)
let operation o l r =
  match (o, r.it) with
  | Div, Number q when Q.sign q = 0 -> Binary (Mul, l, r)
  | _ -> Binary (o, l, r)

(* There is no `behaviour(p).x`. *)
let component e axis =
  match e.it with
  | Apply ({ it = "behaviour"; _ }, _) -> Neg e
  | _ -> Component (e, axis)

let bounds_of expr =
  let* low = expr and* high = expr in
  map (fun filter -> { low; high; filter }) (opt expr)

let over_of expr = oneof [ map (fun e -> Bodies e) expr; map (fun r -> Numbers r) (bounds_of expr) ]

let compound_expr expr =
  let unary f = map f expr in
  oneof
    [
      unary (fun e -> Neg e);
      unary (fun e -> Not e);
      map3 operation binary expr expr;
      map3 operation binary expr expr;
      map3 (fun c t e -> If (c, t, e)) expr expr expr;
      (let* q = oneofl [ Forall; Exists; Count ] in
       map3 (fun p t e -> Quantified (q, p, t, e)) name (over_of expr) expr);
      map3 (fun x y z -> Vector (x, y, z)) expr expr expr;
      temporal_of expr;
      map2 (fun e es -> Event (e, es)) (located (oneofl [ "bind"; "bounce"; "other" ])) (few expr);
      map2 (fun f es -> Apply (f, es)) (oneof [ name; return (loc "behaviour") ]) (few expr);
      map3 (fun p f es -> Apply_in (p, f, es)) (path_of expr) name (few expr);
      map2 component expr name;
    ]

let expr =
  sized_size (int_range 0 12) (fix (fun self n ->
      let smaller = self (n / 2) in
      let leaf = leaf_expr (if n = 0 then located (some (map (fun n -> { name = n; indices = [] }) name))
                            else path_of smaller) in
      located (if n = 0 then leaf else frequency [ (1, leaf); (3, compound_expr smaller) ])))

let operators =
  sized_size (int_range 0 10) (fix (fun self n ->
      let atom = map (fun s -> Path (loc [ { name = loc s; indices = [] } ])) (oneofl [ "a"; "b" ]) in
      let left = self (n / 2) and right = self ((n - 1) / 2) in
      let prefix f = map f (self (n - 1)) in
      located
        (if n <= 0 then atom
         else
           frequency
             [
               (6, map3 operation binary left right);
               (1, prefix (fun e -> Neg e));
               (1, prefix (fun e -> Not e));
               (1, prefix (fun e -> Temporal (Always, None, e)));
               (1, prefix (fun e -> Temporal (Globally A, None, e)));
               (1, map2 (fun e t -> Temporal (Possibly, Some (Within t), e)) left right);
               (2, map2 (fun f g -> Leads_to (f, None, g)) left right);
               (1, map2 (fun f g -> Leads_to (f, Some (At_most f), g)) left right);
               (1, map2 (fun f g -> Leads_to (f, Some (Within g), g)) left right);
             ])))

let segment = segment_of expr
let path = path_of expr
let vector = oneof [ expr; located (map3 (fun x y z -> Vector (x, y, z)) expr expr expr) ]

let feature =
  located
    (oneof
       [ map (fun p -> Named p) path; map2 (fun p vs -> Tuple (p, vs)) (opt path) (some path) ])

let channel =
  let* channel = name in
  let* co = bool in
  let* features = few (map2 (fun feature only -> { feature; only }) feature bool) in
  return { channel; co; features; span = Scc_base.Span.none }

let reference ~indices =
  let* qualifier = opt name and* target = name in
  let plain = { qualifier; target; indices = []; arguments = [] } in
  let applied = map (fun arguments -> { plain with arguments }) (some expr) in
  let indexed = map (fun indices -> { plain with indices }) (some expr) in
  oneof (return plain :: return plain :: applied :: (if indices then [ indexed ] else []))

let definitions = frequency [ (3, return []); (1, some (pair name expr)) ]

let head ~indices =
  let* declared = name in
  let plain = { declared; places = []; formals = [] } in
  let applied = map (fun formals -> { plain with formals }) (some name) in
  let indexed = map (fun places -> { plain with places }) (some expr) in
  oneof (return plain :: return plain :: applied :: (if indices then [ indexed ] else []))

let loosening =
  let odds = map2 (fun odds value -> { odds; value }) (located (oneofl [ "chance"; "rate" ])) expr in
  map2 (fun push odds -> { push; odds }) (opt expr) (opt odds)

let behaviour =
  sized_size (int_range 0 8) (fix (fun self n ->
      let leaf = oneof [ return Nil; map (fun k -> Name k) (reference ~indices:true) ] in
      let next = self (n / 2) in
      located
        (if n = 0 then leaf
         else
           oneof
             [
               leaf;
               map2 (fun c b -> Open (c, b)) channel next;
               map3 (fun c j b -> Weak (c, j, b)) channel loosening next;
               map3 (fun cs j b -> Strong (cs, j, b)) (few channel) (opt expr) next;
               map2 (fun t b -> Delay (t, b)) expr next;
               map2 (fun b c -> Sum (b, c)) next next;
               map2 (fun b c -> Sum (b, c)) next next;
             ])))

let file = located (oneofl [ "a.off"; "a \"b\".obj"; "c:\\x\\y.stl"; "\xC3\xA9.ply"; "" ])

let mending =
  let* grid = option expr and* snap = option expr in
  let* union = bool in
  map3 (fun weld orient merge -> { grid; weld; orient; merge; snap; union }) bool bool bool

let solid =
  sized_size (int_range 0 2) (fix (fun self n ->
      located
        (if n = 0 then
           oneof
             [
               map (fun t -> Template t) (reference ~indices:false); map2 (fun f m -> Mesh (f, m)) file mending;
               map (fun vs -> Hull vs) (few (pair name vector));
             ]
         else map2 (fun s v -> Scaled (s, v)) (self (n - 1)) vector)))

let decomposed =
  let faces = map2 (fun vs fs -> Faces (vs, fs)) (few (pair name vector)) (few (pair name (some name))) in
  sized_size (int_range 0 2) (fix (fun self n ->
      located
        (if n = 0 then oneof [ map2 (fun f m -> Mesh (f, m)) file mending; faces ]
         else map2 (fun s v -> Scaled (s, v)) (self (n - 1)) vector)))

let quadruple = map (fun (a, b, c, d) -> (a, b, c, d)) (quad expr expr expr expr)

let transform =
  located
    (oneof
       [
         map (fun v -> Translate v) vector;
         map (fun (w, x, y, z) -> Rotate (w, x, y, z)) quadruple;
         map (fun v -> Scale v) vector;
         map (fun m -> Matrix m) (list_repeat 4 quadruple);
       ])

let attribute =
  located
    (oneof
       [
         map (fun e -> Mass e) expr; map (fun v -> Velocity v) vector; map (fun v -> Spin v) vector;
         map (fun ts -> At ts) (some transform);
       ])

let leaf_of behaviour =
  let* label = opt segment in
  let* solid = solid in
  let* attributes = few attribute in
  let* behaviour = behaviour in
  return { label; solid; attributes; behaviour; leaf_span = Scc_base.Span.none }

let bond =
  let* bond = name in
  map2 (fun first second -> { bond; first; second; bond_span = Scc_base.Span.none }) feature feature

let part =
  let* part = name in
  map2
    (fun part_solid part_attributes ->
       { part; part_solid; part_attributes; part_span = Scc_base.Span.none })
    solid (few attribute)

let glue =
  map2
    (fun glue_first glue_second -> { glue_first; glue_second; glue_span = Scc_base.Span.none })
    feature feature

let range = map2 (fun index bounds -> { index; bounds }) name (bounds_of expr)

let kick =
  map3
    (fun over (velocity, spin) weight -> { over; velocity; spin; weight })
    (oneof [ return []; some range ]) (pair vector (opt vector)) (opt expr)

let law =
  located
    (oneof
       [
         return Inertial; map2 (fun v w -> Expression (v, w)) vector (opt vector);
         map (fun ks -> Choose ks) (some kick);
       ])

let import =
  let* library = bool in
  let* from = if library then name else file in
  let* names =
    oneof
      [ map (fun n -> Qualified n) (opt name); map (fun ns -> Chosen ns) (some (pair name (opt name))) ]
  in
  return { from; library; names }

let fineness =
  let power k = loc (Number (Q.of_string (Printf.sprintf "1/%d" (1 lsl k)))) in
  oneof [ expr; map power (int_range 0 40) ]

let simple_item =
  let chain behaviour =
    let leaf = leaf_of behaviour in
    triple segment leaf (few (pair bond leaf))
  in
  oneof
    [
      map (fun n -> Model n) name;
      map2 (fun n e -> Param (n, e)) name expr;
      (let limit = map2 (fun value included -> { value; included }) expr bool in
       map3 (fun n low high -> Param_in (n, low, high)) name limit limit);
      map2 (fun e kind -> Timestep (e, kind)) expr (oneofl [ Shared; Local; Steady ]);
      map (fun e -> Split_step e) expr;
      map (fun n -> Dynamics n) (located (oneofl [ "constant_spin"; "free_body"; "other" ]));
      map (fun e -> Resolution e) fineness;
      map2 (fun n e -> Round (n, e)) (located (oneofl [ "orientation"; "velocity"; "other" ])) fineness;
      map (fun i -> Import i) import;
      map3 (fun n s ds -> Shape (n, s, ds)) (head ~indices:false) solid definitions;
      (let* vs = few (pair name vector) in
       let* fs = few (pair name (some name)) in
       map2 (fun n ds -> Shape (n, loc (Faces (vs, fs)), ds)) (head ~indices:false) definitions);
      (let* n = head ~indices:false and* ds = definitions in
       map2 (fun ps gs -> Compound (n, ps, gs, ds)) (few part) (few glue));
      (let* n = head ~indices:false and* ds = definitions in
       map2 (fun s xs -> Decomposed (n, s, xs, ds)) decomposed (few attribute));
      (let* n = head ~indices:true and* ds = definitions in
       map2 (fun t b -> Behaviour (n, t, b, ds)) (opt (reference ~indices:false)) behaviour);
      map (fun (s, l, ls) -> Process (s, l, ls)) (chain (map Option.some behaviour));
      map (fun (s, l, ls) -> Fixed (s, l, ls)) (chain (opt behaviour));
      map (fun b -> Bond b) bond;
      map (fun ps -> Network ps) (few path);
      map2 (fun p l -> Motion (p, l)) (opt path) law;
      map2 (fun n e -> Let (n, e)) name expr;
      map2 (fun n e -> Check (n, e)) name expr;
    ]

let item =
  sized_size (int_range 0 2) (fix (fun self n ->
      if n = 0 then located simple_item
      else
        frequency
          [
            (4, located simple_item);
            (1, located (map2 (fun rs xs -> For (rs, xs)) (some range) (few (self (n - 1)))));
          ]))

let model = list_size (int_range 1 6) item
