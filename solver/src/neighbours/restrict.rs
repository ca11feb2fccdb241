//! Lists of which each particle sees a part only: clusters split into ones that see alike.

use super::{Chunk, Cluster, Lists, Run};

impl Lists {
    /// Takes out of every list the neighbours that its particles do not see. `own(i)` is what decides what particle
    /// `i` sees, the same for all members of a cluster afterwards; `sees(own, slot)` whether that is the neighbour.
    pub fn restrict<K: PartialEq>(
        &mut self,
        own: impl Fn(usize) -> K + Sync,
        sees: impl Fn(&K, usize) -> bool + Sync,
    ) {
        let whole = std::mem::take(self);
        self.lanes = whole.lanes;
        self.assemble(whole.runs.len().saturating_sub(1), |number, chunk| {
            whole
                .run_of(&whole.runs[number..number + 2])
                .restrict(chunk, &own, &sees);
        });
    }
}

impl Run<'_> {
    fn restrict<K: PartialEq>(
        self,
        seen: &mut Chunk,
        own: &impl Fn(usize) -> K,
        sees: &impl Fn(&K, usize) -> bool,
    ) {
        let Chunk { entries, clusters } = seen;
        entries.clear();
        clusters.clear();
        for whole in self.clusters {
            let Cluster {
                targets,
                gas,
                wall,
                is_calm,
            } = whole.clone();
            let mut start = targets.start;
            while start < targets.end {
                let key = own(start);
                let end = (start..targets.end).find(|&i| own(i) != key);
                let end = end.unwrap_or(targets.end);
                let seen = |&&slot: &&u32| sees(&key, slot as usize);
                let begin = entries.len();
                entries.extend(self.entries[gas.clone()].iter().filter(seen));
                let middle = entries.len();
                entries.extend(self.entries[wall.clone()].iter().filter(seen));
                clusters.push(Cluster {
                    targets: start..end,
                    gas: begin..middle,
                    wall: middle..entries.len(),
                    is_calm,
                });
                start = end;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cluster_is_split_where_its_members_see_different_things() {
        let cluster = |targets, gas, wall| Cluster {
            targets,
            gas,
            wall,
            is_calm: false,
        };
        let mut lists = Lists::default();
        lists.lanes = 4;
        lists.assemble(1, |_, chunk| {
            chunk.entries = vec![0, 1, 2, 3, 4, 5];
            chunk.clusters = vec![cluster(0..4, 0..4, 4..6)];
        });
        // Particles below two and above see what is of their own parity.
        lists.restrict(|i| i / 2, |own, slot| slot % 2 == *own);
        let run = lists.all();
        assert_eq!(run.entries, [0, 2, 4, 1, 3, 5]);
        let targets: Vec<_> = run.clusters.iter().map(|c| c.targets.clone()).collect();
        assert_eq!(targets, [0..2, 2..4]);
        assert_eq!(run.clusters[1].gas, 3..5);
        assert_eq!(run.clusters[1].wall, 5..6);
    }
}
