(* An entry is one integer: a value of 28 bits above a column of 32 bits. Columns are places in the order. Values
   are negated, so that a solution is a sum of products: at most 2^56 each, which are reduced from 2^60 on. *)
type t = {
  p : int;
  order : int array;
  lower : int array array;
  upper : int array array;
  inverse : int array;  (** of the diagonal *)
  work : int array;
}

let column e = e land 0xffff_ffff
let value e = e lsr 32
let packed value column = (value lsl 32) lor column

let rec prime_below n =
  let rec has_divisor d = d * d <= n - 1 && ((n - 1) mod d = 0 || has_divisor (d + 1)) in
  if has_divisor 2 then prime_below (n - 1) else n - 1

let inverse p a =
  let rec go r r' s s' = if r' = 0 then s else go r' (r mod r') s' (s - (r / r' * s')) in
  let s = go a p 1 0 mod p in
  if s < 0 then s + p else s

(* The tree of the elimination: the parent of a place is the first of those after it that it is a neighbour of,
   once all before it are eliminated. *)
let tree before =
  let n = Array.length before in
  let parent = Array.make n (-1) and root = Array.make n (-1) in
  let rec climb k j =
    let up = root.(j) in
    if up < 0 then begin
      root.(j) <- k;
      parent.(j) <- k
    end
    else if up <> k then begin
      root.(j) <- k;
      climb k up
    end
  in
  for k = 0 to n - 1 do
    Array.iter (climb k) before.(k)
  done;
  parent

(* The places before k whose rows its own may ask for, each after those that lead to it. *)
let reach ~parent ~mark before k =
  mark.(k) <- k;
  let path j =
    let rec climb j l =
      if mark.(j) = k then l
      else begin
        mark.(j) <- k;
        climb parent.(j) (j :: l)
      end
    in
    climb j []
  in
  Array.fold_left (fun found j -> List.rev_append (path j) found) [] before.(k)

type rows = {
  f : t;
  dense : int array;  (** the row that is being made; 0 between rows *)
  touched : int array;  (** the last row with an entry in each column *)
  columns : int array;  (** the columns of its entries, so many of them *)
  mutable count : int;
}

let touch r k c =
  if r.touched.(c) <> k then begin
    r.touched.(c) <- k;
    r.columns.(r.count) <- c;
    r.count <- r.count + 1
  end

(* Puts row k, with the entries in [dense], into both factors; whether its pivot is not 0. *)
let add_row r k reached =
  let { p; lower; upper; inverse = inverses; _ } = r.f and dense = r.dense in
  let left = ref [] in
  List.iter
    (fun j ->
       if dense.(j) <> 0 then begin
         let l = dense.(j) * inverses.(j) mod p in
         left := packed (p - l) j :: !left;
         let row = upper.(j) in
         for i = 0 to Array.length row - 1 do
           let e = Array.unsafe_get row i in
           let c = column e in
           touch r k c;
           Array.unsafe_set dense c ((Array.unsafe_get dense c + (l * value e)) mod p)
         done
       end)
    reached;
  let right = ref [] in
  for i = 0 to r.count - 1 do
    let c = r.columns.(i) in
    if c > k && dense.(c) <> 0 then right := packed (p - dense.(c)) c :: !right
  done;
  let pivot = dense.(k) in
  for i = 0 to r.count - 1 do
    dense.(r.columns.(i)) <- 0
  done;
  r.count <- 0;
  lower.(k) <- Array.of_list !left;
  upper.(k) <- Array.of_list !right;
  pivot <> 0
  && begin
    inverses.(k) <- inverse p pivot;
    true
  end

let compute ~p ~order ~neighbours ~row ~interrupted =
  let n = Array.length order in
  let place = Array.make n 0 in
  Array.iteri (fun k i -> place.(i) <- k) order;
  let before =
    Array.mapi
      (fun k i ->
         let places = Array.map (Array.get place) neighbours.(i) in
         Array.of_list (List.filter (fun j -> j < k) (Array.to_list places)))
      order
  in
  let parent = tree before and mark = Array.make n (-1) in
  let f =
    let rows () = Array.make n [||] and numbers () = Array.make n 0 in
    { p; order; lower = rows (); upper = rows (); inverse = numbers (); work = numbers () }
  in
  let r =
    { f; dense = Array.make n 0; touched = Array.make n (-1); columns = Array.make n 0; count = 0 }
  in
  let rec go k =
    k = n
    ||
    let put j a =
      touch r k place.(j);
      r.dense.(place.(j)) <- a
    in
    row order.(k) put;
    (k land 0xf <> 0 || not (interrupted ())) && add_row r k (reach ~parent ~mark before k) && go (k + 1)
  in
  if go 0 then Some f else None

let entries f =
  let count = Array.fold_left (fun sum row -> sum + Array.length row) 0 in
  count f.lower + count f.upper

let[@inline] sum ~large (row : int array) (x : int array) start =
  let sum = ref start in
  for i = 0 to Array.length row - 1 do
    let e = Array.unsafe_get row i in
    let more = !sum + (value e * Array.unsafe_get x (column e)) in
    sum := if more >= large then more - large else more
  done;
  !sum

let solve f b =
  let p = f.p and x = f.work and n = Array.length f.order in
  let large = p lsl 32 in
  for k = 0 to n - 1 do
    x.(k) <- b.(f.order.(k))
  done;
  for k = 0 to n - 1 do
    x.(k) <- sum ~large f.lower.(k) x x.(k) mod p
  done;
  for k = n - 1 downto 0 do
    x.(k) <- sum ~large f.upper.(k) x x.(k) mod p * f.inverse.(k) mod p
  done;
  for k = 0 to n - 1 do
    b.(f.order.(k)) <- x.(k)
  done
