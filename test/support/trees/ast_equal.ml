open Scc_syntax
open Ast

(* The constructors without arguments of these types compare as the integers they are. *)
let binary (a : binary) (b : binary) = a = b
let quantifier (a : quantifier) (b : quantifier) = a = b
let path_quantifier (a : path_quantifier) (b : path_quantifier) = a = b

let list = List.equal
let option = Option.equal
let pair f g (a, b) (c, d) = f a c && g b d
let loc f a b = f a.it b.it
let name = loc String.equal

let temporal a b =
  match (a, b) with
  | Possibly, Possibly | Always, Always | Eventually, Eventually -> true
  | Next p, Next q | Finally p, Finally q | Globally p, Globally q -> path_quantifier p q
  | (Possibly | Always | Eventually | Next _ | Finally _ | Globally _), _ -> false

let rec expr a b =
  match (a.it, b.it) with
  | Number p, Number q -> Q.equal p q
  | True, True | False, False -> true
  | Path p, Path q -> path p q
  | Co m, Co n -> name m n
  | Apply (f, xs), Apply (g, ys) -> name f g && list expr xs ys
  | Apply_in (p, f, xs), Apply_in (q, g, ys) -> path p q && name f g && list expr xs ys
  | Component (x, m), Component (y, n) -> expr x y && name m n
  | Vector (x, y, z), Vector (x', y', z') -> expr x x' && expr y y' && expr z z'
  | Neg x, Neg y | Not x, Not y -> expr x y
  | Binary (o, l, r), Binary (o', l', r') -> binary o o' && expr l l' && expr r r'
  | If (c, t, e), If (c', t', e') -> expr c c' && expr t t' && expr e e'
  | Quantified (q, p, t, e), Quantified (q', p', t', e') ->
    quantifier q q' && name p p' && over t t' && expr e e'
  | Temporal (t, d, e), Temporal (t', d', e') -> temporal t t' && option bound d d' && expr e e'
  | Until (q, f, d, g), Until (q', f', d', g') ->
    path_quantifier q q' && expr f f' && option bound d d' && expr g g'
  | Measured (m, t, o), Measured (n, u, p) -> expr m n && option test t u && outcome o p
  | Leads_to (f, d, g), Leads_to (f', d', g') -> expr f f' && option bound d d' && expr g g'
  | Event (e, xs), Event (e', ys) -> name e e' && list expr xs ys
  | ( ( Number _ | True | False | Path _ | Co _ | Apply _ | Apply_in _ | Component _ | Vector _ | Neg _ | Not _
      | Binary _ | If _ | Quantified _ | Temporal _ | Until _ | Measured _ | Leads_to _ | Event _ ), _ ) -> false

and test (o, e) (o', e') = binary o o' && expr e e'

and outcome a b =
  match (a, b) with
  | Does e, Does f -> expr e f
  | Goes_until (f, d, g), Goes_until (f', d', g') -> expr f f' && option bound d d' && expr g g'
  | Has_at (e, t), Has_at (e', t') -> expr e e' && expr t t'
  | (Does _ | Goes_until _ | Has_at _), _ -> false

and bound a b =
  match (a, b) with
  | Within s, Within t | At_most s, At_most t -> expr s t
  | Between (s, t), Between (s', t') -> expr s s' && expr t t'
  | (Within _ | At_most _ | Between _), _ -> false

and over a b =
  match (a, b) with
  | Bodies s, Bodies t -> expr s t
  | Numbers r, Numbers s -> bounds r s
  | (Bodies _ | Numbers _), _ -> false

and bounds a b = expr a.low b.low && expr a.high b.high && option expr a.filter b.filter

and segment a b = name a.name b.name && list expr a.indices b.indices
and path a b = loc (list segment) a b

let vector = expr
let quadruple (a, b, c, d) (w, x, y, z) = expr a w && expr b x && expr c y && expr d z

let feature a b =
  match (a.it, b.it) with
  | Named p, Named q -> path p q
  | Tuple (p, vs), Tuple (q, ws) -> option path p q && list path vs ws
  | (Named _ | Tuple _), _ -> false

let reference (a : reference) (b : reference) =
  option name a.qualifier b.qualifier && name a.target b.target && list expr a.indices b.indices
  && list expr a.arguments b.arguments

let rec solid (a : solid) (b : solid) =
  match (a.it, b.it) with
  | Template m, Template n -> reference m n
  | Scaled (s, v), Scaled (t, w) -> solid s t && vector v w
  | Mesh (f, m), Mesh (g, n) ->
    let words m = [ m.weld; m.orient; m.merge; m.union ] in
    loc String.equal f g && Option.equal expr m.grid n.grid && Option.equal expr m.snap n.snap
    && List.equal Bool.equal (words m) (words n)
  | Faces (vs, fs), Faces (ws, gs) -> list (pair name vector) vs ws && list (pair name (list name)) fs gs
  | Hull vs, Hull ws -> list (pair name vector) vs ws
  | (Template _ | Scaled _ | Mesh _ | Faces _ | Hull _), _ -> false

let transform a b =
  match (a.it, b.it) with
  | Translate v, Translate w | Scale v, Scale w -> vector v w
  | Rotate (w, x, y, z), Rotate (w', x', y', z') -> quadruple (w, x, y, z) (w', x', y', z')
  | Matrix m, Matrix n -> list quadruple m n
  | (Translate _ | Rotate _ | Scale _ | Matrix _), _ -> false

let attribute a b =
  match (a.it, b.it) with
  | Mass x, Mass y -> expr x y
  | Velocity v, Velocity w | Spin v, Spin w -> vector v w
  | At ts, At us -> list transform ts us
  | Absorb, Absorb -> true
  | (Mass _ | Velocity _ | Spin _ | Absorb | At _), _ -> false

let member (a : member) (b : member) = Bool.equal a.only b.only && feature a.feature b.feature

let channel (a : channel) (b : channel) =
  name a.channel b.channel && Bool.equal a.co b.co && list member a.features b.features

let odds (a : odds) (b : odds) = name a.odds b.odds && expr a.value b.value
let loosening a b = Option.equal expr a.push b.push && Option.equal odds a.odds b.odds

let rec behaviour (a : behaviour) (b : behaviour) =
  match (a.it, b.it) with
  | Nil, Nil -> true
  | Open (c, x), Open (d, y) -> channel c d && behaviour x y
  | Weak (c, i, x), Weak (d, j, y) -> channel c d && loosening i j && behaviour x y
  | Strong (cs, i, x), Strong (ds, j, y) -> list channel cs ds && Option.equal expr i j && behaviour x y
  | Delay (t, x), Delay (u, y) -> expr t u && behaviour x y
  | Sum (w, x), Sum (y, z) -> behaviour w y && behaviour x z
  | Name m, Name n -> reference m n
  | (Nil | Open _ | Weak _ | Strong _ | Delay _ | Sum _ | Name _), _ -> false

let bond a b = name a.bond b.bond && feature a.first b.first && feature a.second b.second

let part a b =
  name a.part b.part && solid a.part_solid b.part_solid
  && list attribute a.part_attributes b.part_attributes

let glue a b = feature a.glue_first b.glue_first && feature a.glue_second b.glue_second

let leaf (a : leaf) (b : leaf) =
  option segment a.label b.label && solid a.solid b.solid && list attribute a.attributes b.attributes
  && option behaviour a.behaviour b.behaviour

let range (a : range) (b : range) = name a.index b.index && bounds a.bounds b.bounds

let kick (a : kick) (b : kick) =
  list range a.over b.over && vector a.velocity b.velocity && option vector a.spin b.spin
  && option expr a.weight b.weight

let law a b =
  match (a.it, b.it) with
  | Inertial, Inertial -> true
  | Expression (v, spin), Expression (w, other) -> vector v w && option vector spin other
  | Choose ks, Choose ls -> list kick ks ls
  | (Inertial | Expression _ | Choose _), _ -> false

let head (a : head) (b : head) =
  name a.declared b.declared && list expr a.places b.places && list name a.formals b.formals

let definitions = list (pair name expr)

let imported a b =
  match (a, b) with
  | Qualified m, Qualified n -> option name m n
  | Chosen ms, Chosen ns -> list (pair name (option name)) ms ns
  | (Qualified _ | Chosen _), _ -> false

let import (a : import) (b : import) =
  loc String.equal a.from b.from && Bool.equal a.library b.library && imported a.names b.names

let limit (a : limit) (b : limit) = expr a.value b.value && Bool.equal a.included b.included

let rec item a b =
  match (a.it, b.it) with
  | Model m, Model n -> name m n
  | Param (m, x), Param (n, y) | Let (m, x), Let (n, y) | Check (m, x), Check (n, y) ->
    name m n && expr x y
  | Param_in (m, x, y), Param_in (n, u, v) -> name m n && limit x u && limit y v
  | Timestep (x, n), Timestep (y, k) -> expr x y && n = k
  | Split_step x, Split_step y | Resolution x, Resolution y -> expr x y
  | Dynamics m, Dynamics n | Collisions m, Collisions n | Binding m, Binding n | Bonds m, Bonds n
  | Blocked m, Blocked n -> name m n
  | Round (m, x), Round (n, y) -> name m n && expr x y
  | Import i, Import j -> import i j
  | Shape (m, s, ds), Shape (n, t, es) -> head m n && solid s t && definitions ds es
  | Compound (m, ps, gs, ds), Compound (n, qs, hs, es) ->
    head m n && list part ps qs && list glue gs hs && definitions ds es
  | Decomposed (m, s, xs, ds), Decomposed (n, t, ys, es) ->
    head m n && solid s t && list attribute xs ys && definitions ds es
  | Behaviour (m, t, x, ds), Behaviour (n, u, y, es) ->
    head m n && option reference t u && behaviour x y && definitions ds es
  | Process (m, l, ls), Process (n, k, ks) | Fixed (m, l, ls), Fixed (n, k, ks) ->
    segment m n && leaf l k && list (pair bond leaf) ls ks
  | Bond x, Bond y -> bond x y
  | For (rs, xs), For (ss, ys) -> list range rs ss && list item xs ys
  | Network ps, Network qs -> list path ps qs
  | Motion (p, l), Motion (q, m) -> option path p q && law l m
  | ( ( Model _ | Import _ | Param _ | Param_in _ | Timestep _ | Split_step _ | Dynamics _ | Collisions _
      | Binding _ | Bonds _ | Blocked _ | Resolution _ | Round _ | Shape _
      | Compound _ | Decomposed _ | Behaviour _ | Process _ | Fixed _ | Bond _ | For _ | Network _ | Motion
        _ | Let _
      | Check _ ), _ ) -> false

let model = list item
