open Scc_exact

(* What a variable of the dictionary may be: anything, at least 0, or 0 only. *)
type kind = Free | Slack | Fixed

(* A dictionary: denominator > 0, and for each row r

   denominator * basic_r  =  row.(0) + row.(1) delta + sum over columns c of row.(2 + c) * cobasic_c.

   The variables of the system are 0 .. dimension - 1 and free; constraint number k is variable dimension + k,
   the slack right - normal.x (less delta if strict), which is at least 0, or fixed at 0 for an equality. The
   point at which the solver stands has 0 for all cobasic variables. With the rows of the first dictionary all
   entries of the later ones are minors of it, so that the divisions of a pivot leave no remainders. *)
type t = {
  dimension : int;
  kinds : kind array;
  basic : int array;
  cobasic : int array;
  rows : Z.t array array;
  denominator : Z.t;
}

let columns = 2

let universe n =
  { dimension = n; kinds = Array.make n Free; basic = [||]; cobasic = Array.init n Fun.id; rows = [||];
    denominator = Z.one }

let size t = Array.length t.kinds - t.dimension

(* {1 Several systems as one}

   With the product of all denominators the entries of each are minors of the greater dictionary. *)

(* How many there are before each, of what [count] counts. *)
let before count systems =
  let add (sum, sums) t = (sum + count t, sum :: sums) in
  let total, sums = List.fold_left add (0, []) systems in
  (total, List.rev sums)

let join = function
  | [ t ] -> t
  | systems ->
    let dimension, first = before (fun t -> t.dimension) systems in
    let slacks, first_slack = before size systems in
    let width, first_column = before (fun t -> Array.length t.cobasic) systems in
    let denominator = List.fold_left (fun product t -> Z.mul product t.denominator) Z.one systems in
    let kinds = Array.make (dimension + slacks) Free in
    let place t first first_slack first_column =
      let number v = if v < t.dimension then first + v else dimension + first_slack + v - t.dimension in
      Array.iteri (fun v kind -> kinds.(number v) <- kind) t.kinds;
      let factor = Z.divexact denominator t.denominator in
      let row old =
        let wide = Array.make (columns + width) Z.zero in
        let put j x =
          if Z.sign x <> 0 then wide.(if j < columns then j else first_column + j) <- Z.mul factor x
        in
        Array.iteri put old;
        wide
      in
      (Array.map number t.basic, Array.map number t.cobasic, Array.map row t.rows)
    in
    let rec all placed systems first first_slack first_column =
      match (systems, first, first_slack, first_column) with
      | t :: ts, f :: fs, s :: ss, c :: cs -> all (place t f s c :: placed) ts fs ss cs
      | _ -> List.rev placed
    in
    let placed = all [] systems first first_slack first_column in
    {
      dimension;
      kinds;
      basic = Array.concat (List.map (fun (basic, _, _) -> basic) placed);
      cobasic = Array.concat (List.map (fun (_, cobasic, _) -> cobasic) placed);
      rows = Array.concat (List.map (fun (_, _, rows) -> rows) placed);
      denominator;
    }

(* {1 Pivots} *)

let pivot_row row c ~positive ~denominator =
  let turn = if positive then Z.neg else Fun.id in
  let turned = Array.map turn row in
  turned.(columns + c) <- (if positive then denominator else Z.neg denominator);
  turned

let other_row row pivot c ~positive ~size ~denominator =
  let factor = row.(columns + c) in
  if Z.sign factor = 0 && Z.equal size denominator then row
  else begin
    let divide = if Z.equal denominator Z.one then Fun.id else fun x -> Z.divexact x denominator in
    (* the pivot's sign goes into the factor *)
    let signed = if positive then factor else Z.neg factor in
    let entry j x =
      if j = columns + c then signed
      else if Z.sign factor = 0 || Z.sign pivot.(j) = 0 then
        if Z.sign x = 0 then x else divide (Z.mul x size)
      else divide (Z.sub (Z.mul x size) (Z.mul signed pivot.(j)))
    in
    Array.mapi entry row
  end

(* The basic variable of row r and the cobasic one of column c change places. *)
let pivot t r c =
  Effort.spend (Array.length t.rows * (columns + Array.length t.cobasic));
  let row = t.rows.(r) in
  let p = row.(columns + c) in
  let positive = Z.sign p > 0 and size = Z.abs p and denominator = t.denominator in
  let change k other =
    if k = r then pivot_row row c ~positive ~denominator else other_row other row c ~positive ~size ~denominator
  in
  let rows = Array.mapi change t.rows in
  let basic = Array.copy t.basic and cobasic = Array.copy t.cobasic in
  basic.(r) <- t.cobasic.(c);
  cobasic.(c) <- t.basic.(r);
  { t with rows; basic; cobasic; denominator = size }

(* {1 Feasibility} *)

let sign_of row = if Z.sign row.(0) <> 0 then Z.sign row.(0) else Z.sign row.(1)

(* The index of the least variable among those that pass. *)
let least (variables : int array) passes =
  let best = ref (-1) in
  for k = 0 to Array.length variables - 1 do
    if (!best < 0 || variables.(k) < variables.(!best)) && passes k then best := k
  done;
  !best

let is_violated t r =
  match t.kinds.(t.basic.(r)) with
  | Free -> false
  | Slack -> sign_of t.rows.(r) < 0
  | Fixed -> sign_of t.rows.(r) <> 0

(* Whether the variable of column c can move so that that of the row moves in the direction. *)
let is_suitable t row direction c =
  match t.kinds.(t.cobasic.(c)) with
  | Free -> Z.sign row.(columns + c) <> 0
  | Slack -> Z.sign row.(columns + c) = direction
  | Fixed -> false

let rec restore t =
  let r = least t.basic (is_violated t) in
  if r < 0 then Some t
  else
    let row = t.rows.(r) in
    let c = least t.cobasic (is_suitable t row (-sign_of row)) in
    if c < 0 then None else restore (pivot t r c)

(* The row of right - normal.x - strict * delta *)
let row_of t normal ~right ~strict =
  Effort.spend (Array.length t.rows * (columns + Array.length t.cobasic));
  let row = Array.make (columns + Array.length t.cobasic) Z.zero in
  row.(0) <- Z.mul t.denominator right;
  if strict then row.(1) <- Z.neg t.denominator;
  let from_column c v =
    if v < t.dimension && Z.sign normal.(v) <> 0 then
      row.(columns + c) <- Z.sub row.(columns + c) (Z.mul t.denominator normal.(v))
  in
  let from_row r v =
    if v < t.dimension && Z.sign normal.(v) <> 0 then
      Array.iteri (fun j x -> if Z.sign x <> 0 then row.(j) <- Z.sub row.(j) (Z.mul normal.(v) x)) t.rows.(r)
  in
  Array.iteri from_column t.cobasic;
  Array.iteri from_row t.basic;
  row

let append a x = Array.append a [| x |]

let with_row t kind row =
  { t with kinds = append t.kinds kind; basic = append t.basic (Array.length t.kinds); rows = append t.rows row }

let constraint_row t (c : Constraint.t) =
  if Constraint.dimension c <> t.dimension then Scc_base.Bug.fail __POS__ "a constraint of another dimension";
  row_of t c.normal ~right:c.right ~strict:(c.relation = Less)

let add t (c : Constraint.t) =
  restore (with_row t (if c.relation = Equal then Fixed else Slack) (constraint_row t c))

let value t normal =
  let row = row_of t normal ~right:Z.zero ~strict:false in
  let part j = Rat.make (Z.neg row.(j)) t.denominator in
  (part 0, part 1)

(* Of a strict constraint the slack has to be positive; it may be less than delta, which can be made smaller. *)
let satisfies t (c : Constraint.t) =
  let sign = sign_of (constraint_row t (Constraint.closed c)) in
  match c.relation with
  | Equal -> sign = 0
  | Less -> sign > 0
  | At_most -> sign >= 0

let implies t c = satisfies t c && List.for_all (fun other -> add t other = None) (Constraint.negation c)

(* {1 One constraint turned round, or forgotten} *)

let position (variables : int array) v =
  let k = least variables (fun k -> variables.(k) = v) in
  if k < 0 then None else Some k

let set a k x =
  let copy = Array.copy a in
  copy.(k) <- x;
  copy

(* For a slack s, strict or not, the negation of the constraint has the slack -s - delta. *)
let turned_round t v =
  match position t.basic v with
  | Some r ->
    let row = Array.map Z.neg t.rows.(r) in
    row.(1) <- Z.sub row.(1) t.denominator;
    { t with rows = set t.rows r row }
  | None ->
    let c = columns + Option.get (position t.cobasic v) in
    let change row =
      if Z.sign row.(c) = 0 then row
      else
        let copy = Array.copy row in
        copy.(1) <- Z.sub row.(1) row.(c);
        copy.(c) <- Z.neg row.(c);
        copy
    in
    { t with rows = Array.map change t.rows }

let slack t k =
  let v = t.dimension + k in
  if t.kinds.(v) <> Slack then Scc_base.Bug.fail __POS__ "not an inequality of the system";
  v

let is_redundant t k = restore (turned_round t (slack t k)) = None

let remove a k = Array.append (Array.sub a 0 k) (Array.sub a (k + 1) (Array.length a - k - 1))

let without t k =
  let v = slack t k in
  let t = { t with kinds = set t.kinds v Free } in
  match position t.basic v with
  | Some r -> { t with basic = remove t.basic r; rows = remove t.rows r }
  | None -> t

(* {1 Points} *)

let coordinates t value =
  let point = Array.make t.dimension Rat.zero in
  Array.iteri (fun r v -> if v < t.dimension then point.(v) <- value t.rows.(r)) t.basic;
  point

(* For a small delta all slacks are at least 0: here it is half of the greatest that is small enough, at most
    1/2. *)
let small_enough t =
  let consider delta row v =
    if t.kinds.(v) = Slack && Z.sign row.(1) < 0 then Rat.min delta (Rat.make row.(0) (Z.neg row.(1))) else delta
  in
  let delta = ref Rat.one in
  Array.iteri (fun r v -> delta := consider !delta t.rows.(r) v) t.basic;
  Rat.mul Rat.half !delta

let point t =
  let delta = small_enough t in
  coordinates t (fun row ->
      let infinitesimal = Rat.mul (Q.of_bigint row.(1)) delta in
      Rat.div (Rat.add (Q.of_bigint row.(0)) infinitesimal) (Q.of_bigint t.denominator))

(* {1 Bounds} *)

type bound = Unbounded | Bound of { value : Rat.t; attained : bool }

(* Of two rows the one whose slack is used up first when the variable of column c moves. *)
let compare_limits t c r s =
  let p = t.rows.(r) and q = t.rows.(s) in
  let size row = Z.abs row.(columns + c) in
  let against j = Z.compare (Z.mul p.(j) (size q)) (Z.mul q.(j) (size p)) in
  let order = against 0 in
  let order = if order <> 0 then order else against 1 in
  if order <> 0 then order else Int.compare t.basic.(r) t.basic.(s)

let limiting t c direction =
  let limits r =
    match t.kinds.(t.basic.(r)) with
    | Free -> false
    | Slack -> Z.sign t.rows.(r).(columns + c) * direction < 0
    | Fixed -> Z.sign t.rows.(r).(columns + c) <> 0
  in
  let best = ref (-1) in
  for r = 0 to Array.length t.basic - 1 do
    if limits r && (!best < 0 || compare_limits t c r !best < 0) then best := r
  done;
  !best

(* Raises the free variable of the row as far as it gets. *)
let rec raise_row t objective =
  let row = t.rows.(objective) in
  let c = least t.cobasic (is_suitable t row 1) in
  if c < 0 then
    Bound { value = Rat.make row.(0) t.denominator; attained = Z.sign row.(1) = 0 }
  else
    let r = limiting t c (Z.sign row.(columns + c)) in
    if r < 0 then Unbounded else raise_row (pivot t r c) objective

(* The constraint f <= 0 has the normal of f, but for a positive factor. *)
let factor (f : Linear.t) (c : Constraint.t) =
  match Constraint.first_variable c with
  | None -> Rat.one
  | Some i -> Rat.div f.coefficients.(i) (Q.of_bigint c.normal.(i))

(* A row for -normal.x is raised, which lowers the form. *)
let infimum t (f : Linear.t) =
  let c = Constraint.of_form f At_most in
  if Constraint.dimension c <> t.dimension then Scc_base.Bug.fail __POS__ "a form of another dimension";
  let lowered = with_row t Free (row_of t c.normal ~right:Z.zero ~strict:false) in
  match raise_row lowered (Array.length t.rows) with
  | Unbounded -> Unbounded
  | Bound { value; attained } ->
    Bound { value = Rat.sub f.constant (Rat.mul (factor f c) value); attained }

let supremum t f =
  match infimum t (Linear.neg f) with
  | Unbounded -> Unbounded
  | Bound { value; attained } -> Bound { value = Rat.neg value; attained }

(* {1 Corners} *)

(* Free variables move as far as they get, into the basis, for good. *)
let cornered t =
  let rec from t c =
    if c >= Array.length t.cobasic then t
    else if t.kinds.(t.cobasic.(c)) <> Free then from t (c + 1)
    else
      let up = limiting t c 1 in
      let r = if up >= 0 then up else limiting t c (-1) in
      from (if r < 0 then t else pivot t r c) (c + 1)
  in
  from t 0

let closed_point t =
  let t = cornered t in
  coordinates t (fun row -> Rat.make row.(0) t.denominator)
