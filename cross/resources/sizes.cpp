// One array for each type that a program holds in RAM, of the type's size, which is read from the symbols.
#include "osem/osem.hpp"

#define OSEM_SIZE(name) unsigned char size_of_##name[sizeof(osem::name)]

OSEM_SIZE(Node);
OSEM_SIZE(NodePool);
OSEM_SIZE(Edge);
OSEM_SIZE(Octree);
OSEM_SIZE(TreeBuilder);
OSEM_SIZE(Conversion);
OSEM_SIZE(GridConversion);
OSEM_SIZE(Labelling);
OSEM_SIZE(Fitting);
OSEM_SIZE(Pruning);
OSEM_SIZE(Appraisal);
OSEM_SIZE(Combination);
OSEM_SIZE(StreamReader);
OSEM_SIZE(StreamBuilder);
OSEM_SIZE(StreamCursor);
OSEM_SIZE(StreamCombination);
OSEM_SIZE(CsgConversion);
OSEM_SIZE(CsgSolid);
OSEM_SIZE(CsgTree);
OSEM_SIZE(CsgStream);
OSEM_SIZE(ClusterWalk);
OSEM_SIZE(SurfaceMeasurement);
OSEM_SIZE(Boundary);
OSEM_SIZE(BoundaryCorner);
OSEM_SIZE(ComponentLabelling);
OSEM_SIZE(Component);
OSEM_SIZE(SegmentWalk);
OSEM_SIZE(NeighbourWalk);
OSEM_SIZE(Collision);
OSEM_SIZE(NodeWalk);
OSEM_SIZE(LeafWalk);
OSEM_SIZE(Translation);
OSEM_SIZE(Reorientation);
OSEM_SIZE(Coarsening);
OSEM_SIZE(RowWalk);
OSEM_SIZE(RunSlicing);
OSEM_SIZE(BitmapSlicing);
