let pairs list =
  let rec go found = function
    | [] -> List.rev found
    | x :: rest -> go (List.fold_left (fun found y -> (x, y) :: found) found rest) rest
  in
  go [] list

let product ones twos = List.concat_map (fun a -> List.map (fun b -> (a, b)) twos) ones

let neighbours list =
  let rec go found = function
    | a :: (b :: _ as rest) -> go ((a, b) :: found) rest
    | [ _ ] | [] -> List.rev found
  in
  go [] list

let ring = function [] -> [] | first :: _ as list -> neighbours (list @ [ first ])

let take n list =
  let rec go taken n = function
    | x :: rest when n > 0 -> go (x :: taken) (n - 1) rest
    | _ -> List.rev taken
  in
  go [] n list

let distinct equal list =
  List.rev (List.fold_left (fun kept x -> if List.exists (equal x) kept then kept else x :: kept) [] list)

let put joined x list =
  let rec go before = function
    | [] -> List.rev (x :: before)
    | y :: rest -> (
        match joined y with
        | Some z -> List.rev_append before (z :: rest)
        | None -> go (y :: before) rest)
  in
  go [] list

let merged compare add list =
  let step merged (key, value) =
    match merged with
    | (last, sum) :: rest when compare key last = 0 -> (last, add sum value) :: rest
    | _ -> (key, value) :: merged
  in
  List.stable_sort (fun (a, _) (b, _) -> compare a b) list |> List.fold_left step [] |> List.rev
