type sent = { id : string; data : int array Lazy.t }
type t = { mutable count : int; documents : (string, sent list) Hashtbl.t }

(* A client that has cancelled a request asks by the id before. *)
let most_kept = 2

let create () = { count = 0; documents = Hashtbl.create 16 }
let known t uri = Option.value (Hashtbl.find_opt t.documents uri) ~default:[]

let find t ~uri id =
  Option.map (fun s -> s.data) (List.find_opt (fun s -> String.equal s.id id) (known t uri))

let add t ~uri data =
  t.count <- t.count + 1;
  let id = string_of_int t.count in
  Hashtbl.replace t.documents uri (Scc_data.Lists.take most_kept ({ id; data } :: known t uri));
  id

let forget t uri = Hashtbl.remove t.documents uri

let word = 5

let difference before after =
  let n = Array.length before / word and m = Array.length after / word in
  let same i j =
    let part words at k : int = words.((at * word) + k) in
    let rec from k = k >= word || (Int.equal (part before i k) (part after j k) && from (k + 1)) in
    from 0
  in
  let rec first k = if k < n && k < m && same k k then first (k + 1) else k in
  let start = first 0 in
  let rec last k =
    if k < n - start && k < m - start && same (n - 1 - k) (m - 1 - k) then last (k + 1) else k
  in
  let common = last 0 in
  if start = n && start = m then None
  else
    let put = Array.sub after (start * word) ((m - common - start) * word) in
    Some (start * word, (n - common - start) * word, put)
