(** The syntax tree of a model: what was written, with its places, before any name is looked up. *)

open Scc_base

type 'a loc = { it : 'a; at : Span.t }

type name = string loc

(** [c[i,j]]: a name with its indices (none for a plain name). *)
type segment = { name : name; indices : expr list }

(** [c[i].left.right]: at least one segment. *)
and path = segment list loc

(** Numbers, vectors, truth values, laws of motion and formulas are one syntax; elaboration tells them apart. *)
and expr = expr_kind loc

and expr_kind =
  | Number of Q.t
  | True
  | False
  | Path of path  (** a parameter, loop variable, [let], process, [momentum.x], [quiescent], … *)
  | Co of name  (** [~a], an argument of [offers] *)
  | Apply of name * expr list  (** [bonds(a)], [round(e, q)], … *)
  | Apply_in of path * name * expr list  (** [m.K(a)]: of the import m, a behaviour or shape with arguments *)
  | Component of expr * name  (** [cross(v, w).x], [(v + w).x] *)
  | Vector of expr * expr * expr
  | Neg of expr
  | Not of expr
  | Binary of binary * expr * expr
  | If of expr * expr * expr
  | Quantified of quantifier * name * over * expr  (** variable, what it ranges over, body *)
  | Temporal of temporal * bound option * expr
  | Until of path_quantifier * expr * bound option * expr  (** [A[ f U[b] g ]] *)
  | Measured of expr * (binary * expr) option * outcome
  (** [P >= 1/2 [ f U g ]], [Pmax = ? [ eventually f ]], [E = ? [ x(p) at 10 ]]: what is measured, as written; what
      it is compared with, or asked for ([None]); of what *)
  | Leads_to of expr * bound option * expr  (** [f leads_to[b] g], [f leads_to g within t] *)
  | Event of name * expr list  (** [event bind(a, p, q)] *)

(** What the runs of a model do, or come to. *)
and outcome =
  | Does of expr  (** [eventually f], [always f] *)
  | Goes_until of expr * bound option * expr  (** [f U[b] g] *)
  | Has_at of expr * expr  (** [e at t] *)

(** What a quantifier ranges over. *)
and over =
  | Bodies of expr  (** [T]: a template, process or family, as written *)
  | Numbers of bounds  (** [a..b if c] *)

(** [a..b if c]: the integers from a to b for which c holds. *)
and bounds = { low : expr; high : expr; filter : expr option }

and binary = Add | Sub | Mul | Div | Mod | Lt | Le | Gt | Ge | Eq | Ne | And | Or | Implies
and quantifier = Forall | Exists | Count
and path_quantifier = A | E

(** [possibly], [always] and [eventually] are EF, AG and AF with an English bound ([within t]). *)
and temporal =
  | Possibly
  | Always
  | Eventually
  | Next of path_quantifier
  | Finally of path_quantifier
  | Globally of path_quantifier

and bound =
  | Within of expr  (** [within t] *)
  | At_most of expr  (** [[<= t]] *)
  | Between of expr * expr  (** [[a, b]] *)

(** An expression whose value is a vector. *)
type vector = expr

(** A feature as written: [right], [q.left.right], [[a,b]], [q.left.[a,b]]. *)
type feature = feature_kind loc

and feature_kind =
  | Named of path  (** the last segment names a vertex or a face *)
  | Tuple of path option * path list  (** [prefix.[v1,…,vn]]; a vertex may carry a prefix of its own *)

(** [T], [m.T(a, b)], [K[i, j]]: something that a module declares, with what it is applied to. *)
type reference = { qualifier : name option; target : name; indices : expr list; arguments : expr list }

(** What is done to a mesh, in this order: the options of [scc shape], and of [scc decompose]. *)
type mending = {
  grid : expr option;  (** coordinates become multiples of it *)
  weld : bool;
  orient : bool;
  merge : bool;
  snap : expr option;  (** how far its vertices may be moved *)
  union : bool;  (** all that its faces surround becomes one solid *)
}

type solid = solid_kind loc

and solid_kind =
  | Template of reference
  | Scaled of solid * vector
  | Mesh of string loc * mending  (** the file's path as written *)
  | Faces of (name * vector) list * (name * name list) list  (** vertices, faces *)
  | Hull of (name * vector) list

type transform = transform_kind loc

and transform_kind =
  | Translate of vector
  | Rotate of expr * expr * expr * expr  (** a quaternion w, x, y, z *)
  | Scale of vector
  | Matrix of (expr * expr * expr * expr) list  (** four rows *)

type attribute = attribute_kind loc

and attribute_kind =
  | Mass of expr
  | Velocity of vector
  | Spin of vector
  | Absorb
  | At of transform list  (** [T1 * T2 * …], the last applied first; not empty *)

(** A member of an active surface; [only]: without its closure. *)
type member = { feature : feature; only : bool }

(** A channel [<a, {f1,…}>], [omega(a, {…})] or an entry of [rho]. *)
type channel = { channel : name; co : bool; features : member list; span : Span.t }

(** [chance 1/10] or [rate 2] of a weak split: the word, which may be another one yet, and the number. *)
type odds = { odds : name; value : expr }

type loosening = { push : expr option; odds : odds option }
type behaviour = behaviour_kind loc

and behaviour_kind =
  | Nil
  | Open of channel * behaviour  (** [<alpha, Phi>. B] *)
  | Weak of channel * loosening * behaviour  (** [omega(a, Phi). B], perhaps with a [push(j)] and [chance q] *)
  | Strong of channel list * expr option * behaviour  (** [rho({…}). B], perhaps with a [push(j)] *)
  | Delay of expr * behaviour  (** [eps(t). B] *)
  | Sum of behaviour * behaviour
  | Name of reference  (** K *)

(** A bond or a glue's pair: [<a, {f1, f2}>]. *)
type bond = { bond : name; first : feature; second : feature; bond_span : Span.t }

type part = { part : name; part_solid : solid; part_attributes : attribute list; part_span : Span.t }
type glue = { glue_first : feature; glue_second : feature; glue_span : Span.t }

(** One S[B] of a process: [label] is absent when the process has this leaf alone and gives it its name. *)
type leaf = {
  label : segment option;
  solid : solid;
  attributes : attribute list;
  behaviour : behaviour option;  (** always present, but for [fixed] *)
  leaf_span : Span.t;
}

(** [where x = e, y = f]: names that a declaration has for itself. *)
type definitions = (name * expr) list

type range = { index : name; bounds : bounds }

type law = law_kind loc

and law_kind =
  | Inertial
  | Expression of vector * vector option  (** with a spin, if it is given *)
  | Choose of kick list

(** A velocity of a choice, with its spin and its weight or none; or many, as in
    [for i in 1..3: (i, 0, 0) weight 1/i]. *)
and kick = { over : range list; velocity : vector; spin : vector option; weight : expr option }

(** Whose movement steps are, and what ends them: [local], [steady], or neither. *)
type pace = Shared | Local | Steady

(** What a declaration names: [K], [K[i, 0]] (integers, or variables for them), [K(a, b)]. *)
type head = { declared : name; places : expr list; formals : name list }

(** An end of a range: [[0] or [(0]. *)
type limit = { value : expr; included : bool }

(** [import "x.sc"], [import <solids>]. *)
type import = { from : string loc; library : bool; names : imported }

and imported =
  | Qualified of name option  (** [as s]; by the name of the file if there is none *)
  | Chosen of (name * name option) list  (** [(Cube, Wall as W)] *)

type item = item_kind loc

and item_kind =
  | Model of name
  | Import of import
  | Param of name * expr
  | Param_in of name * limit * limit  (** [param x in [0, 6]] *)
  | Timestep of expr * pace
  | Split_step of expr
  | Dynamics of name
  | Collisions of name
  | Binding of name
  | Bonds of name
  | Blocked of name
  | Resolution of expr
  | Round of name * expr  (** of what, [orientation] or [velocity]; to multiples of what *)
  | Shape of head * solid * definitions
  | Compound of head * part list * glue list * definitions
  | Decomposed of head * solid * attribute list * definitions
  (** [compound C = decompose "c.obj" mass 1]: of a [Mesh], of [Faces], or of one of them [Scaled] *)
  | Behaviour of head * reference option * behaviour * definitions  (** [on] a template *)
  | Process of segment * leaf * (bond * leaf) list
  | Fixed of segment * leaf * (bond * leaf) list
  | Bond of bond
  | For of range list * item list
  | Network of path list  (** empty for [network nil] *)
  | Motion of path option * law  (** [None]: for every process *)
  | Let of name * expr
  | Check of name * expr

type model = item list
